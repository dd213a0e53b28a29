(* A control, which check.sh must refuse: a proof of 2 = 1 by a function whose end is taken on trust. *)
#[bypass_check(guard)] Fixpoint absurd (n : nat) : False := absurd n.
Theorem two_is_one : 2 = 1.
Proof. destruct (absurd 0). Qed.
