package org.dfra.security;

import java.util.Optional;

/**
 * On whose behalf a member calls, as the credential says that the call carries.
 *
 * @param principal the member who has delegated the call; empty if the credential proves nothing
 * @param fault why it proves nothing, in a sentence; empty if it does
 */
public record Behalf(Optional<Member> principal, String fault) {

  /** Checks that it has a principal or a fault. */
  public Behalf {
    if (principal.isPresent() != fault.isEmpty()) {
      throw new IllegalArgumentException(principal + " with fault \"" + fault + "\"");
    }
  }

  /** For a member. */
  public static Behalf of(Member principal) {
    return new Behalf(Optional.of(principal), "");
  }

  /** A credential that proves nothing. */
  public static Behalf unproved(String fault) {
    return new Behalf(Optional.empty(), fault);
  }

  /** As in sentences, such as {@code operator anna of field}. */
  @Override
  public String toString() {
    return principal.map(Member::toString).orElse("somebody whom nothing proves");
  }
}
