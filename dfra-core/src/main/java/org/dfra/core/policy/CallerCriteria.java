package org.dfra.core.policy;

import java.util.Locale;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.dfra.core.policy.PolicyRule.Effect;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;

/**
 * Which callers a rule is about.
 *
 * @param standings what their certificates prove
 * @param roles their roles; empty for all, also for strangers, which have none
 * @param members their names
 * @param sameRobot true: only the robot that the called object belongs to; false: only others; null
 *     for all
 * @param behalf on whose behalf they call
 */
record CallerCriteria(
    Set<Standing> standings,
    Set<MemberRole> roles,
    NamePattern members,
    @Nullable Boolean sameRobot,
    BehalfCriteria behalf) {

  /** The standings of a rule about what is seen that names none. */
  static final Set<Standing> OTHERS = Set.of(Standing.MEMBER, Standing.EXPIRED, Standing.STRANGER);

  /** The standings of a rule that names none: a permit is for valid members, a denial for all. */
  static Set<Standing> defaultStandings(Effect effect) {
    return effect == Effect.PERMIT
        ? Set.of(Standing.OWN, Standing.MEMBER)
        : Set.of(Standing.values());
  }

  CallerCriteria {
    standings = Set.copyOf(standings);
    roles = Set.copyOf(roles);
  }

  /** Whether they name roles, members or robots, and not only what certificates prove. */
  boolean isNamed() {
    return !roles.isEmpty() || !members.isAny() || sameRobot != null || behalf.isNamed();
  }

  /**
   * Why it is not about a caller, as a part of a sentence; null if it is.
   *
   * @param robot the robot that the called object belongs to; empty if to none
   */
  @Nullable String mismatch(Caller caller, String robot, Effect effect) {
    if (!standings.contains(caller.standing())) {
      return "the caller is " + words(caller.standing()) + ", not " + standingsInWords();
    }
    Optional<Member> member = caller.member();
    if (!roles.isEmpty() && (member.isEmpty() || !roles.contains(member.get().role()))) {
      return "the caller's role is "
          + member.map(each -> each.role().text()).orElse("none")
          + ", not "
          + roles.stream().sorted().map(MemberRole::text).collect(Collectors.joining(" or "));
    }
    if (!members.isAny() && (member.isEmpty() || !members.matches(member.get().name()))) {
      return "the caller's name is "
          + member.map(Member::name).orElse("unknown")
          + ", not "
          + members;
    }
    @Nullable String other = behalf.mismatch(caller.behalf(), effect);
    if (other != null) {
      return other;
    }
    Truth expected = sameRobot == null ? Truth.HOLDS : isSame(member, robot, sameRobot);
    return expected.applies(effect)
        ? null
        : "the caller is "
            + (Boolean.TRUE.equals(sameRobot) ? "not known to be" : "not known to be other than")
            + " the robot of the called object";
  }

  private static Truth isSame(Optional<Member> member, String robot, boolean expected) {
    boolean isRobot = member.isPresent() && member.get().role() == MemberRole.ROBOT;
    if (!isRobot) {
      return Truth.of(!expected);
    }
    return robot.isEmpty()
        ? Truth.UNKNOWN
        : Truth.of(member.get().name().equals(robot) == expected);
  }

  private String standingsInWords() {
    return standings.stream()
        .sorted()
        .map(CallerCriteria::words)
        .collect(Collectors.joining(" or "));
  }

  private static String words(Standing standing) {
    return switch (standing) {
      case STRANGER -> "a stranger";
      case EXPIRED -> "a member with an expired certificate";
      case MEMBER -> "a member";
      case OWN -> "a process of the same robot or person";
    };
  }

  /** The word for a standing in policies. */
  static String text(Standing standing) {
    return standing.name().toLowerCase(Locale.ROOT);
  }
}
