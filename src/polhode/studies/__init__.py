"""Questions that measurements answer, such as how an asteroid tumbles: one file each, from the data to a report."""
