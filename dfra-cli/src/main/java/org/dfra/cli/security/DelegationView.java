package org.dfra.cli.security;

import java.time.Instant;
import java.util.List;
import org.dfra.river.identity.Delegation;

/**
 * A delegation as commands show it.
 *
 * @param from on whose behalf
 * @param to who may act
 * @param robots names of the robots that it may command
 * @param until its last instant
 * @param state valid or expired
 */
record DelegationView(String from, String to, List<String> robots, Instant until, String state) {

  DelegationView {
    robots = List.copyOf(robots);
  }

  static DelegationView of(Delegation delegation, Instant now) {
    return new DelegationView(
        delegation.principal().toString(),
        delegation.bearer().toString(),
        delegation.robots(),
        delegation.until(),
        now.isAfter(delegation.until()) ? "expired" : "valid");
  }

  /** A line about what a computer has accepted. */
  String line() {
    return "May command "
        + String.join(", ", robots)
        + " for "
        + from
        + " until "
        + until
        + (state.equals("valid") ? "." : ": " + state + ".");
  }
}
