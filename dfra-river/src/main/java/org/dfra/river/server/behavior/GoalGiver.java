package org.dfra.river.server.behavior;

import java.lang.reflect.Method;
import java.math.BigInteger;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.river.remote.behavior.RemoteBehavior;
import org.dfra.security.AccessRequest;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;

/**
 * Who has given or resumed a goal, as a behaviour stores it for its next process: a line such as
 * {@code 5f3a 77;policy=12;method=pursue;standing=MEMBER;member=field/robot/atrv2;
 * for=field/operator/anna}.
 *
 * @param certificates numbers of the caller's certificate and of that of the member on whose behalf
 *     it called; empty for the robot's own processes
 * @param call the call; null if no guard has decided about it
 */
record GoalGiver(List<BigInteger> certificates, @Nullable GoalCall call) {

  private static final int RADIX = 16;
  private static final String PARTS = ";";

  /** Of a caller of an earlier process no address is known. */
  private static final String ADDRESS = "an earlier call";

  /**
   * The call of a goal.
   *
   * @param caller as it was when it called
   * @param method name of the method of {@link RemoteBehavior}
   * @param policy version of the last policy that is known to permit it
   */
  record GoalCall(Caller caller, String method, long policy) {

    /** The call as a guard decides about it. */
    AccessRequest request(String robot, String object, Class<?> type) {
      Method called =
          Arrays.stream(RemoteBehavior.class.getMethods())
              .filter(each -> each.getName().equals(method))
              .findFirst()
              .orElseThrow(() -> new IllegalArgumentException("no method \"" + method + "\""));
      return new AccessRequest(caller, robot, object, type, called);
    }

    /** The member or members, as in sentences. */
    String who() {
      return caller.member().map(Member::toString).orElse("a stranger")
          + caller.behalf().map(each -> " for " + each).orElse("");
    }
  }

  /** Copies the list. */
  GoalGiver {
    certificates = List.copyOf(certificates);
  }

  /** The caller of a goal. */
  static GoalGiver of(
      List<BigInteger> certificates, Optional<AccessRequest> permitted, long policy) {
    return new GoalGiver(
        certificates,
        permitted
            .map(each -> new GoalCall(each.caller(), each.method().getName(), policy))
            .orElse(null));
  }

  /** The same, permitted by another policy too. */
  GoalGiver reviewedBy(long policy) {
    return call == null
        ? this
        : new GoalGiver(certificates, new GoalCall(call.caller(), call.method(), policy));
  }

  /** The line; empty if nobody is known. */
  String text() {
    Stream<String> numbers = certificates.stream().map(number -> number.toString(RADIX));
    String line = numbers.collect(Collectors.joining(" "));
    if (call == null) {
      return line;
    }
    Caller caller = call.caller();
    return line
        + ";policy="
        + call.policy()
        + ";method="
        + call.method()
        + ";standing="
        + caller.standing()
        + caller.member().map(each -> ";member=" + text(each)).orElse("")
        + caller.behalf().flatMap(Behalf::principal).map(each -> ";for=" + text(each)).orElse("");
  }

  private static String text(Member member) {
    return member.team() + "/" + member.role().text() + "/" + member.name();
  }

  /**
   * Reads {@link #text}.
   *
   * @throws IllegalArgumentException if it is none
   */
  static GoalGiver parse(String text) {
    List<String> parts = List.of(text.split(PARTS, -1));
    List<BigInteger> numbers =
        Stream.of(parts.get(0).split(" ", -1))
            .filter(each -> !each.isEmpty())
            .map(each -> new BigInteger(each, RADIX))
            .toList();
    Map<String, String> named = new HashMap<>();
    for (String each : parts.subList(1, parts.size())) {
      int at = each.indexOf('=');
      if (at < 0) {
        throw new IllegalArgumentException("\"" + each + "\" is no name=value");
      }
      named.put(each.substring(0, at), each.substring(at + 1));
    }
    return new GoalGiver(numbers, named.isEmpty() ? null : call(named));
  }

  private static GoalCall call(Map<String, String> named) {
    Caller alone =
        new Caller(
            Caller.Standing.valueOf(named.getOrDefault("standing", "")), // which no standing is
            Optional.ofNullable(named.get("member")).map(GoalGiver::member),
            ADDRESS);
    @Nullable String principal = named.get("for");
    return new GoalCall(
        principal == null ? alone : alone.onBehalfOf(Behalf.of(member(principal))),
        named.getOrDefault("method", ""),
        Long.parseLong(named.getOrDefault("policy", "")));
  }

  private static Member member(String text) {
    String[] parts = text.split("/", -1);
    if (parts.length != 3) {
      throw new IllegalArgumentException("\"" + text + "\" is no team/role/name");
    }
    return new Member(parts[0], MemberRole.of(parts[1]), parts[2]);
  }
}
