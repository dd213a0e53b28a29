"""What a page is made of: samples, pictures that fit any body, the page itself, and the live view."""
