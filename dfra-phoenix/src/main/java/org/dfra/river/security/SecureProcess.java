package org.dfra.river.security;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.server.ExportException;
import java.security.GeneralSecurityException;
import java.time.InstantSource;
import java.util.Objects;
import java.util.Optional;
import org.dfra.core.audit.AuditEvent;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.core.audit.AuditSettings;
import org.dfra.core.audit.AuditTrail;
import org.dfra.module.Module;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.identity.FlooredClock;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.security.budget.ProcessBudgets;
import org.dfra.river.security.news.NewsExchange;
import org.dfra.river.security.robot.PolicyControls;
import org.dfra.river.security.robot.RobotState;
import org.dfra.security.MemberRole;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * The security of this process: open if its computer has joined no team; secure with the identity
 * of its team; closed if there is an identity that cannot be used. It never becomes open again.
 */
public final class SecureProcess {

  /**
   * System property: the folder with the identity, {@code security} in the state folder. Phoenix
   * and the groups that it starts get it from the command that starts them.
   */
  public static final String PROPERTY = "dfra.security";

  private static final Logger LOG = LoggerFactory.getLogger(SecureProcess.class);

  /**
   * What was installed.
   *
   * @param name of the member whose identity it is, such as {@code robot atrv1 of field}; empty in
   *     the open mode
   * @param robot name of the robot; empty if the identity is a person's, or there is none
   * @param fault why it is closed, in a sentence; empty otherwise
   */
  public record Installed(SecurityMode mode, String name, String robot, String fault) {

    static final Installed OPEN = new Installed(SecurityMode.OPEN, "", "", "");
  }

  @GuardedBy("SecureProcess.class")
  private static @Nullable Installed installed;

  @GuardedBy("SecureProcess.class")
  private static @Nullable ProcessIdentity identity;

  @GuardedBy("SecureProcess.class")
  private static @Nullable KnownTime time;

  private static volatile @Nullable NewsExchange news;
  private static volatile @Nullable RobotState robot;
  private static volatile @Nullable PolicyControls control;

  private static volatile @Nullable ProcessBudgets budgets;

  private static volatile @Nullable SecurityWatch watch;

  private SecureProcess() {}

  /** The folder of the identity in a state folder. */
  public static Path folder(Path state) {
    return state.resolve(SecurityFiles.FOLDER);
  }

  /** How this process is; open if nothing was installed. */
  public static synchronized Installed current() {
    return Objects.requireNonNullElse(installed, Installed.OPEN);
  }

  /**
   * Installs the identity that the system property {@value #PROPERTY} names, if it is set. For the
   * main methods of robots' processes, before they read or export anything remote.
   *
   * @throws IllegalStateException if there is an identity that cannot be used, and not even a
   *     robot's own key with which the process could run closed: it must not run at all
   */
  public static Installed installFromProperty() {
    @Nullable String folder = System.getProperty(PROPERTY);
    if (folder == null) {
      return Installed.OPEN;
    }
    Installed own = install(Path.of(folder), false);
    if (own.mode() == SecurityMode.CLOSED) { // commands say it themselves
      LOG.error("This process works for its own robot only: {}", own.fault());
    }
    return own;
  }

  /**
   * Installs an identity.
   *
   * @param folder {@code security} in the state folder
   * @param believesExpired whether robots with an expired certificate are called too, as only
   *     stopping them needs
   * @throws IllegalStateException if there is an identity that cannot be used, and not even a
   *     robot's own key with which the process could run closed: it must not run at all
   */
  public static synchronized Installed install(Path folder, boolean believesExpired) {
    if (installed == null) {
      installed =
          IdentityFolder.isJoined(folder) ? installMember(folder, believesExpired) : Installed.OPEN;
    }
    return installed;
  }

  @GuardedBy("SecureProcess.class")
  private static Installed installMember(Path folder, boolean believesExpired) {
    ProcessIdentity made;
    SecurityMode mode;
    String fault;
    @Nullable KnownTime known = null;
    @Nullable RobotState shared = null;
    try (StoredPolicy policy = StoredPolicy.begin(folder)) {
      TeamCredentials credentials = IdentityFolder.load(folder);
      boolean isLasting = System.getProperty(PROPERTY) != null; // no command
      known = KnownTime.of(folder, credentials, InstantSource.system(), isLasting);
      fault = fault(credentials, known.clock());
      mode = fault.isEmpty() ? SecurityMode.SECURE : SecurityMode.CLOSED;
      if (mode == SecurityMode.SECURE && credentials.member().role() == MemberRole.ROBOT) {
        shared = new RobotState(state(folder), known.clock(), SecureProcess::lookSoon);
      }
      made =
          ProcessIdentity.of(
              credentials, folder, policy, mode, believesExpired, known.clock(), shared);
    } catch (IdentityException | IOException | GeneralSecurityException e) {
      mode = SecurityMode.CLOSED;
      fault = Objects.toString(e.getMessage(), e.toString());
      made = closed(folder, fault);
      shared = null;
    }
    identity = made;
    time = known;
    CurrentIdentity.setForProcess(made.identity());
    ProcessBudgets limits = null;
    if (!made.identity().robot().isEmpty()) {
      limits = new ProcessBudgets(made.budgets(), state(folder));
      limits.policyChanged();
      budgets = limits;
    }
    watch = SecurityWatch.start(folder, made, new SecurityWatch.Parts(known, shared, limits));
    if (mode == SecurityMode.SECURE) {
      news =
          new NewsExchange(
              folder, made.authority(), made.identity(), made::numbers, SecureProcess::readAgain);
      TrustedCode.trustTeam(
          new TeamCode(made.authority(), made.revoked(), Objects.requireNonNull(known).clock()));
    }
    if (shared != null) {
      robot = shared;
      control = new PolicyControls(shared);
    }
    return new Installed(mode, made.identity().member().toString(), made.identity().robot(), fault);
  }

  /** Has a request for confirmation shown to operators. */
  private static void lookSoon() {
    @Nullable SecurityWatch watching = watch;
    if (watching != null) {
      watching.wake();
    }
  }

  /**
   * Why this computer's clock does not count, in a sentence with the remedy; empty if it does, or
   * if this process is open.
   */
  public static synchronized Optional<String> clockFault() {
    return Optional.ofNullable(time).flatMap(KnownTime::fault);
  }

  /**
   * Exports what other members call in each process of a member, at the port of everything else
   * that it exports at a host. Does nothing the second time, and nothing if this process is open.
   *
   * @param host address of this computer, as in its proxies
   */
  public static void export(String host) throws ExportException {
    @Nullable NewsExchange exchanged = news;
    if (exchanged != null) {
      exchanged.export(host);
    }
    @Nullable PolicyControls controlled = control;
    if (controlled != null) {
      controlled.export(host);
    }
    @Nullable ProcessBudgets limits = budgets;
    if (limits != null) {
      limits.export(host);
    }
  }

  /**
   * Takes the robot's position from a module of this process, if it knows it and this process is a
   * secure robot's.
   *
   * @return ends that
   */
  public static AutoCloseable offerPosition(Module module) {
    @Nullable RobotState own = robot;
    return own == null ? () -> {} : own.offerPosition(module);
  }

  /**
   * The identity of another member, for {@link CurrentIdentity#callAs}: in programs that act for
   * several, such as demonstrations. Its policy and list of revoked certificates stay as they are
   * now.
   *
   * @param folder {@code security} in the member's state folder
   * @throws IdentityException if it cannot be used; the message says why
   * @throws GeneralSecurityException if this virtual machine cannot use the key
   */
  public static ChannelIdentity other(Path folder)
      throws IdentityException, IOException, GeneralSecurityException {
    try (StoredPolicy policy = StoredPolicy.begin(folder)) {
      TeamCredentials credentials = IdentityFolder.load(folder);
      FlooredClock clock = KnownTime.of(folder, credentials, InstantSource.system(), false).clock();
      return ProcessIdentity.of(
              credentials, folder, policy, SecurityMode.SECURE, false, clock, null)
          .identity();
    }
  }

  /**
   * Takes a policy or a list of revoked certificates that was just written into the folder of the
   * identity. Without it, this process notices the change a little later.
   */
  public static void readAgain() {
    SecurityWatch watching = watch;
    if (watching != null) {
      watching.look();
    }
  }

  /** Exchanges news of the authority with others; empty if this process is not secure. */
  public static Optional<NewsExchange> news() {
    return Optional.ofNullable(news);
  }

  /** What may be used of this process; empty if it is open, or no robot's. */
  public static Optional<ProcessBudgets> budgets() {
    return Optional.ofNullable(budgets);
  }

  /** Why nobody else would believe this member; empty if they do. */
  private static String fault(TeamCredentials credentials, InstantSource clock) {
    if (credentials.isRevoked()) {
      return "the certificate of "
          + credentials.member()
          + " is revoked; ask the team's authority for a new one";
    }
    return credentials.validityFault(clock.instant()).orElse("");
  }

  /**
   * Starts the audit trail of a process with an identity. If it cannot be written, the process
   * works without one and says so in its log.
   *
   * @param stream name of the trail, which no other process writes
   */
  public static synchronized void startAudit(String stream) {
    ProcessIdentity own = identity;
    @Nullable String folder = System.getProperty(PROPERTY);
    if (own == null || folder == null) {
      return;
    }
    AuditTrail trail =
        new AuditTrail(
            AuditSettings.of(
                AuditSettings.folder(state(Path.of(folder))),
                stream,
                own.identity().member().toString()),
            InstantSource.system());
    try {
      trail.start();
    } catch (IOException e) { // a robot works on a full disk too
      LOG.error("Calls of this process are not recorded: {}", e.getMessage());
      return;
    }
    Runtime.getRuntime().addShutdownHook(new Thread(trail::close, "audit-end"));
    own.audit(trail);
    trail.record(AuditEvent.processStarted(current().mode(), current().fault()));
  }

  private static Path state(Path folder) {
    return Objects.requireNonNull(folder.toAbsolutePath().getParent());
  }

  /** The robot's own key has no dates, and a file of its own. */
  private static ProcessIdentity closed(Path folder, String fault) {
    try {
      return ProcessIdentity.closed(IdentityFolder.loadAlone(folder), InstantSource.system());
    } catch (IdentityException | GeneralSecurityException e) {
      boolean isRobot =
          Files.exists(folder.resolve(SecurityFiles.ROBOT)); // a person has no such key
      throw new IllegalStateException(
          isRobot
              ? fault + " (and this process cannot work for itself: " + e.getMessage() + ")"
              : fault,
          e);
    }
  }
}
