package org.dfra.river.security;

import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.PrivateKey;
import java.security.PublicKey;
import java.security.cert.X509CRL;
import java.security.cert.X509Certificate;
import java.time.Duration;
import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.dfra.core.audit.AuditEvent;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.core.audit.AuditTrail;
import org.dfra.core.audit.AuditedGuard;
import org.dfra.core.audit.KeptHead;
import org.dfra.core.budget.BudgetGuard;
import org.dfra.core.budget.Budgets;
import org.dfra.core.policy.BuiltInPolicies;
import org.dfra.core.policy.Confirmations;
import org.dfra.core.policy.DecisionLog;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyFacts;
import org.dfra.core.policy.PolicyGuard;
import org.dfra.core.policy.method.MethodKind;
import org.dfra.core.policy.method.MethodKinds;
import org.dfra.river.identity.FlooredClock;
import org.dfra.river.identity.RevokedCertificates;
import org.dfra.river.identity.RobotAlone;
import org.dfra.river.identity.StoredDelegations;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.river.identity.TeamCredentials.RobotKey;
import org.dfra.river.identity.TeamIdentity;
import org.dfra.river.security.budget.UnlimitedCalls;
import org.dfra.river.security.news.TeamNews;
import org.dfra.river.security.robot.RobotState;
import org.dfra.security.AccessRequest;
import org.dfra.security.Decision;
import org.dfra.security.ForwardingGuard;
import org.dfra.security.Guard;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.dfra.security.Permissions;
import org.jspecify.annotations.Nullable;

/** The parts of a process's identity that change while it runs: its policy, and who is revoked. */
final class ProcessIdentity {

  private static final Duration HEAD_PATIENCE = Duration.ofSeconds(5);

  private final TeamIdentity identity;
  private final RevokedCertificates revoked;
  private final PolicyGuard policy;
  private final BudgetGuard budgets;
  private final ReplaceableGuard guard;
  private final X509Certificate authority;
  private final @Nullable StoredDelegations delegations;
  private final boolean isClosed;
  private final @Nullable PrivateKey key; // null if others do not believe its certificate
  private volatile @Nullable AuditTrail audit;

  private ProcessIdentity(
      TeamIdentity identity,
      RevokedCertificates revoked,
      PolicyGuard policy,
      BudgetGuard budgets,
      ReplaceableGuard guard,
      X509Certificate authority,
      @Nullable StoredDelegations delegations,
      boolean isClosed,
      @Nullable PrivateKey key) {
    this.delegations = delegations;
    this.isClosed = isClosed;
    this.key = key;
    this.identity = identity;
    this.revoked = revoked;
    this.policy = policy;
    this.budgets = budgets;
    this.guard = guard;
    this.authority = authority;
  }

  /**
   * The identity of a member.
   *
   * @param folder with what others have delegated to it
   * @param read its policy
   * @param mode secure, or closed if others no longer believe the certificate
   * @param believesExpired whether servers with an expired certificate are called
   * @param robot facts and confirmations for its policy; null if it is a person
   * @throws IOException if the policy cannot be read, or the authority has not signed it
   * @throws GeneralSecurityException if the list of revoked certificates or the key cannot be used
   */
  static ProcessIdentity of(
      TeamCredentials credentials,
      Path folder,
      StoredPolicy read,
      SecurityMode mode,
      boolean believesExpired,
      FlooredClock clock,
      @Nullable RobotState robot)
      throws IOException, GeneralSecurityException {
    String team = credentials.member().team();
    Optional<Policy> stored = read.get(credentials.authority());
    Policy policy =
        mode == SecurityMode.CLOSED
            ? BuiltInPolicies.closed(team)
            : stored.orElseGet(() -> BuiltInPolicies.standard(team));
    RevokedCertificates revoked = new RevokedCertificates(credentials.authority());
    Optional<X509CRL> list = credentials.revocations();
    if (list.isPresent()) {
      boolean unused = revoked.replace(list.get());
    }
    Set<PublicKey> otherOwn =
        credentials.robotKey().map(it -> Set.of(it.certificate().getPublicKey())).orElse(Set.of());
    PolicyGuard guard =
        new PolicyGuard(
            policy,
            robot == null ? PolicyFacts.none() : robot.facts(),
            robot == null ? Confirmations.none() : robot.confirmations(),
            new DecisionLog(System::nanoTime),
            clock,
            System::nanoTime);
    BudgetGuard budgets = budgets(guard, credentials.member());
    ReplaceableGuard asked = new ReplaceableGuard(budgets, mode == SecurityMode.CLOSED);
    TeamIdentity identity =
        new TeamIdentity(
            new TeamIdentity.Settings(
                credentials.member(),
                new TeamIdentity.Key(credentials.privateKey(), List.of(credentials.chain())),
                otherOwn,
                credentials.subject().getPrincipals(),
                credentials.authority(),
                revoked,
                asked,
                believesExpired),
            clock);
    StoredDelegations delegations =
        new StoredDelegations(
            folder, credentials, method -> kind(method) == MethodKind.COMMAND, clock);
    delegations.reload();
    if (mode == SecurityMode.SECURE) {
      identity.carry(delegations);
    }
    return new ProcessIdentity(
        identity,
        revoked,
        guard,
        budgets,
        asked,
        credentials.authority(),
        delegations,
        mode == SecurityMode.CLOSED,
        mode == SecurityMode.CLOSED ? null : credentials.privateKey());
  }

  private static MethodKind kind(Method method) {
    return MethodKinds.of(method.getDeclaringClass(), method).kind();
  }

  /**
   * The identity of a robot of which no more than its own key can be used.
   *
   * @throws GeneralSecurityException if the key cannot be used
   */
  static ProcessIdentity closed(RobotAlone robot, InstantSource clock)
      throws GeneralSecurityException {
    RobotKey key = robot.key();
    Member member = robot.member();
    RevokedCertificates revoked = new RevokedCertificates(robot.authority());
    PolicyGuard guard = new PolicyGuard(BuiltInPolicies.closed(member.team()));
    BudgetGuard budgets = budgets(guard, member);
    ReplaceableGuard asked = new ReplaceableGuard(budgets, true);
    TeamIdentity identity =
        new TeamIdentity(
            new TeamIdentity.Settings(
                member,
                new TeamIdentity.Key(key.key(), List.of(key.certificate())),
                Set.of(),
                Set.of(),
                robot.authority(),
                revoked,
                asked,
                false),
            clock);
    return new ProcessIdentity(
        identity, revoked, guard, budgets, asked, robot.authority(), null, true, null);
  }

  /** Budgets are for what uses a robot; a person's programs have none. */
  private static BudgetGuard budgets(PolicyGuard guard, Member member) {
    boolean isRobot = member.role() == MemberRole.ROBOT;
    return new BudgetGuard(
        guard,
        () -> isRobot ? guard.policy().budgets() : Budgets.NONE,
        member.name(),
        new UnlimitedCalls());
  }

  /** The transport has it before the audit trail is there. */
  private static final class ReplaceableGuard extends ForwardingGuard {

    private final boolean isClosed;
    private volatile Guard guard;

    ReplaceableGuard(Guard guard, boolean isClosed) {
      this.guard = guard;
      this.isClosed = isClosed;
    }

    @Override
    protected Guard guard() {
      return guard;
    }

    @Override
    public Decision decide(AccessRequest request) {
      return guard.decide(request);
    }

    /** A robot that has become closed goes on with what its members had begun. */
    @Override
    public Permissions permissions() {
      return isClosed ? Permissions.LASTING : guard.permissions();
    }
  }

  /** Records all further decisions and events. */
  void audit(AuditTrail trail) {
    audit = trail;
    guard.guard =
        new AuditedGuard(
            budgets, trail, method -> kind(method) == MethodKind.READ, policy::obligations);
  }

  /** Whether there is an audit trail whose end can be signed. */
  boolean hasHead() {
    return audit != null && key != null;
  }

  /**
   * Signs the end of the audit trail, which is on the disk then.
   *
   * @throws IOException if the trail cannot be written now
   */
  KeptHead head() throws IOException, InterruptedException {
    @Nullable AuditTrail trail = audit;
    @Nullable PrivateKey signer = key;
    if (trail == null || signer == null) {
      throw new IOException("this process has no audit trail that others believe");
    }
    return KeptHead.of(trail.head(signer, HEAD_PATIENCE), identity.certificate());
  }

  /** Records an event, if there is an audit trail. */
  void record(AuditEvent event) {
    @Nullable AuditTrail trail = audit;
    if (trail != null) {
      trail.record(event);
    }
  }

  /** Reads again what others have delegated to this member, if its files have changed. */
  void reloadDelegations() {
    if (delegations != null) {
      delegations.reload();
    }
  }

  /** Whether it has the closed policy, which no other one replaces. */
  boolean isClosed() {
    return isClosed;
  }

  /** What is in force. */
  TeamNews.Numbers numbers() {
    return new TeamNews.Numbers(revoked.number().longValue(), policy.policy().version());
  }

  TeamIdentity identity() {
    return identity;
  }

  RevokedCertificates revoked() {
    return revoked;
  }

  PolicyGuard policy() {
    return policy;
  }

  BudgetGuard budgets() {
    return budgets;
  }

  X509Certificate authority() {
    return authority;
  }
}
