(* A control, which check.sh must refuse: a proof of 2 = 1 by a type that contains its own negation. *)
#[bypass_check(positivity)] Inductive bad : Type := c : (bad -> False) -> bad.
Lemma none : bad -> False.
Proof. intros [f]. exact (f (c f)). Qed.
Theorem two_is_one : 2 = 1.
Proof. destruct (none (c none)). Qed.
