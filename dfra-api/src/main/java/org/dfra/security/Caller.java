package org.dfra.security;

import java.util.Optional;

/**
 * The program that makes a call, as far as it is known.
 *
 * @param standing what its certificate proves
 * @param member whom the certificate names; empty for a stranger
 * @param address its numeric address, or a substitute text
 * @param behalf on whose behalf it calls; empty if on its own
 */
public record Caller(
    Standing standing, Optional<Member> member, String address, Optional<Behalf> behalf) {

  /** What is proved of a caller. */
  public enum Standing {
    /** It has no certificate of this team. */
    STRANGER,
    /** A member whose certificate has expired: it may stop robots, and is a stranger otherwise. */
    EXPIRED,
    /** A member of the team. */
    MEMBER,
    /** A process of the same robot or of the same person as the called one: it has the same key. */
    OWN
  }

  /** Checks that a stranger is nobody and acts for nobody, and everybody else is somebody. */
  public Caller {
    if ((standing == Standing.STRANGER) != member.isEmpty()
        || (member.isEmpty() && behalf.isPresent())) {
      throw new IllegalArgumentException(
          standing + " with member " + member + ", on behalf of " + behalf);
    }
  }

  /** A program that calls on its own behalf. */
  public Caller(Standing standing, Optional<Member> member, String address) {
    this(standing, member, address, Optional.empty());
  }

  /** A program without a certificate of this team. */
  public static Caller stranger(String address) {
    return new Caller(Standing.STRANGER, Optional.empty(), address);
  }

  /** The same program without what its call carries: on its own behalf. */
  public Caller alone() {
    return behalf.isEmpty() ? this : new Caller(standing, member, address);
  }

  /** The same program on somebody's behalf. */
  public Caller onBehalfOf(Behalf principal) {
    return new Caller(standing, member, address, Optional.of(principal));
  }

  /**
   * As in sentences, such as {@code operator anna of field (192.0.2.7)} or {@code robot atrv1 of
   * field for operator anna of field (192.0.2.7)}.
   */
  @Override
  public String toString() {
    String who = member.map(Member::toString).orElse("a stranger");
    String expired = standing == Standing.EXPIRED ? ", whose certificate has expired" : "";
    return who + behalf.map(each -> " for " + each).orElse("") + expired + " (" + address + ")";
  }
}
