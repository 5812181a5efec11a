"""What a run leaves behind: SVG with credits, pictures, contact sheets, and a report of it all."""
