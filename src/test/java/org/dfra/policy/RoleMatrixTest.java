package org.dfra.policy;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.InvocationTargetException;
import java.lang.reflect.Method;
import java.lang.reflect.Proxy;
import java.rmi.Remote;
import java.security.GeneralSecurityException;
import java.time.Clock;
import java.time.Duration;
import java.time.Instant;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.concurrent.CopyOnWriteArrayList;
import net.jini.core.constraint.RemoteMethodControl;
import net.jini.id.Uuid;
import net.jini.id.UuidFactory;
import net.jini.jeri.BasicJeriExporter;
import net.jini.jeri.BasicObjectEndpoint;
import org.dfra.core.policy.BuiltInPolicies;
import org.dfra.core.policy.PolicyGuard;
import org.dfra.river.access.GuardedObject;
import org.dfra.river.call.DeadlineILFactory;
import org.dfra.river.call.PeerAddress;
import org.dfra.river.fixture.TestTeam;
import org.dfra.river.fixture.TestTeam.Issued;
import org.dfra.river.identity.AnonymousIdentity;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.river.transport.TransportEndpoint;
import org.dfra.river.transport.TransportServerEndpoint;
import org.dfra.security.AccessRefusedException;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/**
 * Each role, with a certificate of its own and over TLS, calls each remote method of an exported
 * object. A call that is to be permitted arrives at the object, and no other does.
 */
@Timeout(300)
class RoleMatrixTest {

  private static final String HOST = "127.0.0.1";
  private static final String TEAM = "field";
  private static final String ROBOT = "atrv1";
  private static final Duration DEADLINE = Duration.ofSeconds(20);

  /** Without {@code dfra.full}, a method that interfaces inherit is called at the first only. */
  private static final boolean IS_FULL = Boolean.getBoolean("dfra.full");

  private final TestTeam authority = new TestTeam(TEAM);
  private final RevokedCertificates revoked = new RevokedCertificates(authority.authority());
  private final PolicyGuard guard = new PolicyGuard(BuiltInPolicies.standard(TEAM));
  private final Issued robots = authority.issue(new Member(TEAM, MemberRole.ROBOT, ROBOT));
  private final List<String> arrived = new CopyOnWriteArrayList<>();
  private final List<String> wrong = new ArrayList<>();
  private int permitted;
  private int refused;

  private TeamIdentity identity(MemberRole role, String name, Issued issued)
      throws GeneralSecurityException {
    return new TeamIdentity(
        new TeamIdentity.Settings(
            new Member(TEAM, role, name),
            new TeamIdentity.Key(issued.key(), List.of(issued.certificate())),
            Set.of(),
            Set.of(),
            authority.authority(),
            revoked,
            guard,
            false),
        Clock.systemUTC());
  }

  private TeamIdentity member(MemberRole role, String name) throws GeneralSecurityException {
    return identity(role, name, authority.issue(new Member(TEAM, role, name)));
  }

  /** Who calls, and as whom the robot is to know the caller. */
  private Map<Caller, ChannelIdentity> callers() throws GeneralSecurityException {
    Instant now = Instant.now();
    Member gone = new Member(TEAM, MemberRole.OPERATOR, "gone");
    Issued expired =
        authority.issue(gone.x500(), now.minus(Duration.ofDays(9)), now.minus(Duration.ofHours(1)));
    Map<Caller, ChannelIdentity> callers = new LinkedHashMap<>();
    callers.put(
        caller(Standing.OWN, MemberRole.ROBOT, ROBOT), identity(MemberRole.ROBOT, ROBOT, robots));
    for (MemberRole role : MemberRole.values()) {
      callers.put(caller(Standing.MEMBER, role, "other"), member(role, "other"));
    }
    callers.put(
        caller(Standing.EXPIRED, MemberRole.OPERATOR, "gone"),
        identity(MemberRole.OPERATOR, "gone", expired));
    callers.put(Caller.stranger(HOST), AnonymousIdentity.instance());
    return callers;
  }

  private static Caller caller(Standing standing, MemberRole role, String name) {
    return new Caller(standing, Optional.of(new Member(TEAM, role, name)), HOST);
  }

  /** Each call that arrives is noted, and answered by nothing. */
  private Remote implementation(Class<?> type) {
    return (Remote)
        Proxy.newProxyInstance(
            getClass().getClassLoader(),
            new Class<?>[] {type, GuardedObject.class},
            (self, method, arguments) -> {
              if (method.getDeclaringClass() == Object.class) {
                return switch (method.getName()) {
                  case "equals" -> self == arguments[0];
                  case "hashCode" -> System.identityHashCode(self);
                  default -> "an object of " + type.getName();
                };
              } else if (method.getDeclaringClass() == GuardedObject.class) {
                return "object";
              }
              arrived.add(signature(method));
              return nothing(method.getReturnType());
            });
  }

  private static String signature(Method method) {
    return method.getName() + List.of(method.getParameterTypes());
  }

  private static Object nothing(Class<?> type) {
    return type.isPrimitive() && type != void.class
        ? java.lang.reflect.Array.get(java.lang.reflect.Array.newInstance(type, 1), 0)
        : null;
  }

  @Test
  void eachRoleReachesWhatItMayCallAndNothingElse() throws Exception {
    ChannelIdentity robot = identity(MemberRole.ROBOT, ROBOT, robots);
    Map<Caller, ChannelIdentity> callers = callers();
    Set<String> called = new java.util.HashSet<>();
    for (Class<?> type : RemoteInterfaces.ALL) {
      Uuid id = UuidFactory.generate();
      BasicJeriExporter exporter =
          new BasicJeriExporter(
              CurrentIdentity.callAs(robot, () -> new TransportServerEndpoint(HOST, 0)),
              new DeadlineILFactory(),
              false,
              true,
              id);
      Remote kept = implementation(type); // JERI holds it weakly
      int port = PeerAddress.of(exporter.export(kept)).port();
      try {
        for (Method method : type.getMethods()) {
          boolean isFirst = called.add(method.getDeclaringClass().getName() + signature(method));
          if (!isFirst && !IS_FULL) {
            continue;
          }
          for (Map.Entry<Caller, ChannelIdentity> each : callers.entrySet()) {
            check(each.getKey(), proxy(type, id, port, each.getValue()), type, method);
          }
        }
      } finally {
        boolean unused = exporter.unexport(true);
        assertThat(kept).isNotNull();
      }
    }
    System.out.printf(
        "role × method: %d calls arrived, %d were refused, %d wrongly%n",
        permitted, refused, wrong.size());
    assertThat(wrong).isEmpty();
    assertThat(permitted).isGreaterThan(IS_FULL ? 1000 : 250);
    assertThat(refused).isGreaterThan(IS_FULL ? 1000 : 250);
  }

  private static Object proxy(Class<?> type, Uuid id, int port, ChannelIdentity client)
      throws Exception {
    return CurrentIdentity.callAs(
        client,
        () ->
            DeadlineILFactory.proxy(
                new BasicObjectEndpoint(new TransportEndpoint(HOST, port), id, false),
                DEADLINE,
                RoleMatrixTest.class.getClassLoader(),
                type,
                RemoteMethodControl.class));
  }

  private void check(Caller caller, Object proxy, Class<?> type, Method method) throws Exception {
    arrived.clear();
    Object[] arguments = new Object[method.getParameterCount()];
    for (int i = 0; i < arguments.length; i++) {
      arguments[i] = nothing(method.getParameterTypes()[i]);
    }
    String outcome;
    method.setAccessible(true); // the interface of reggie is package-private
    try {
      Object unused = method.invoke(proxy, arguments);
      outcome = "answered";
    } catch (InvocationTargetException e) {
      outcome =
          e.getCause() instanceof AccessRefusedException ? "refused" : "failed: " + e.getCause();
    }
    boolean isExpected = ExpectedPermissions.permit(caller, type, method, ROBOT);
    List<String> expected = isExpected ? List.of(signature(method)) : List.of();
    if (outcome.equals(isExpected ? "answered" : "refused") && arrived.equals(expected)) {
      permitted += isExpected ? 1 : 0;
      refused += isExpected ? 0 : 1;
    } else {
      wrong.add(
          "%s calls %s of %s: %s, arrived: %s, expected: %s"
              .formatted(caller, method.getName(), type.getName(), outcome, arrived, isExpected));
    }
  }
}
