package org.dfra.core.policy;

import java.lang.reflect.Method;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import org.dfra.core.policy.method.InterfaceCatalogue;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;

/** What the tests of policies share. */
final class PolicyFixture {

  static final Caller ANNA = member(Standing.MEMBER, MemberRole.OPERATOR, "anna");
  static final Caller BOB = member(Standing.MEMBER, MemberRole.OBSERVER, "bob");
  static final Caller ATRV1 = member(Standing.MEMBER, MemberRole.ROBOT, "atrv1");
  static final Caller OWN = member(Standing.OWN, MemberRole.ROBOT, "atrv1");
  static final Caller STRANGER = Caller.stranger("192.0.2.66");

  private PolicyFixture() {}

  static Caller member(Standing standing, MemberRole role, String name) {
    return new Caller(standing, Optional.of(new Member("field", role, name)), "192.0.2.7");
  }

  /** A policy of team field with these rules, each on a line; the first is on line 2. */
  static String xml(long version, String... lines) {
    return "<policy xmlns=\"urn:dfra:policy:1\" team=\"field\" version=\""
        + version
        + "\">\n"
        + String.join("\n", lines)
        + "\n</policy>\n";
  }

  static Policy policy(String... lines) {
    return version(1, lines);
  }

  static Policy version(long version, String... lines) {
    return read(xml(version, lines));
  }

  static Policy read(String xml) {
    return PolicyXml.read(
        xml.getBytes(StandardCharsets.UTF_8), "policy.xml", InterfaceCatalogue.builtIn());
  }

  /** A call of a drive of robot atrv1. */
  static AccessRequest call(Caller caller, String method) {
    return call(caller, DriveEffector.class, method);
  }

  static AccessRequest call(Caller caller, Class<?> type, String method) {
    return new AccessRequest(caller, "atrv1", "drive", type, method(type, method));
  }

  static Method method(Class<?> type, String name) {
    return Arrays.stream(type.getMethods())
        .filter(each -> each.getName().equals(name))
        .findFirst()
        .orElseThrow(() -> new AssertionError(type + " has no " + name));
  }
}
