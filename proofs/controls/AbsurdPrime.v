(* A control, which check.sh must refuse: a proof of 2 = 1 from an axiom with a prime in its name. *)
Hypothesis magic' : 2 = 1.
Theorem two_is_one : 2 = 1.
Proof. exact magic'. Qed.
