"""Icons and photos as Qt draws them."""
