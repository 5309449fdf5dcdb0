package org.dfra.security;

import java.util.Optional;

/**
 * The program that makes a call, as far as it is known.
 *
 * @param standing what its certificate proves
 * @param member whom the certificate names; empty for a stranger
 * @param address its numeric address, or a substitute text
 */
public record Caller(Standing standing, Optional<Member> member, String address) {

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

  /** Checks that a stranger is nobody, and everybody else somebody. */
  public Caller {
    if ((standing == Standing.STRANGER) != member.isEmpty()) {
      throw new IllegalArgumentException(standing + " with member " + member);
    }
  }

  /** A program without a certificate of this team. */
  public static Caller stranger(String address) {
    return new Caller(Standing.STRANGER, Optional.empty(), address);
  }

  /** As in sentences, such as {@code operator anna of field (192.0.2.7)}. */
  @Override
  public String toString() {
    String who = member.map(Member::toString).orElse("a stranger");
    return switch (standing) {
      case EXPIRED -> who + ", whose certificate has expired (" + address + ")";
      default -> who + " (" + address + ")";
    };
  }
}
