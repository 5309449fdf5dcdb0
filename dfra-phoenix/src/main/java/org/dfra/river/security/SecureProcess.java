package org.dfra.river.security;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.time.Clock;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Objects;
import java.util.Optional;
import org.dfra.core.audit.AuditEvent;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.core.audit.AuditSettings;
import org.dfra.core.audit.AuditTrail;
import org.dfra.river.identity.ChannelIdentity;
import org.dfra.river.identity.CurrentIdentity;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.TeamCredentials;
import org.dfra.river.loading.TrustedCode;
import org.dfra.river.security.news.NewsExchange;
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

  private static volatile @Nullable NewsExchange news;

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
    try {
      TeamCredentials credentials = IdentityFolder.load(folder);
      fault = fault(credentials);
      mode = fault.isEmpty() ? SecurityMode.SECURE : SecurityMode.CLOSED;
      made = ProcessIdentity.of(credentials, folder, mode, believesExpired, Clock.systemUTC());
    } catch (IdentityException | IOException | GeneralSecurityException e) {
      mode = SecurityMode.CLOSED;
      fault = Objects.toString(e.getMessage(), e.toString());
      made = closed(folder, fault);
    }
    identity = made;
    CurrentIdentity.setForProcess(made.identity());
    watch = SecurityWatch.start(folder, made);
    if (mode == SecurityMode.SECURE) {
      news = new NewsExchange(folder, made.authority(), made.identity(), made::numbers);
      TrustedCode.trustTeam(new TeamCode(made.authority(), made.revoked(), Clock.systemUTC()));
    }
    return new Installed(mode, made.identity().member().toString(), made.identity().robot(), fault);
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
    return ProcessIdentity.of(
            IdentityFolder.load(folder), folder, SecurityMode.SECURE, false, Clock.systemUTC())
        .identity();
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

  /** Why nobody else would believe this member; empty if they do. */
  private static String fault(TeamCredentials credentials) {
    if (credentials.isRevoked()) {
      return "the certificate of "
          + credentials.member()
          + " is revoked; ask the team's authority for a new one";
    }
    return credentials.validityFault(Instant.now()).orElse("");
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
    Path state = Objects.requireNonNull(Path.of(folder).toAbsolutePath().getParent());
    AuditTrail trail =
        new AuditTrail(
            AuditSettings.of(
                AuditSettings.folder(state), stream, own.identity().member().toString()),
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

  /** The robot's own key has no dates, and a file of its own. */
  private static ProcessIdentity closed(Path folder, String fault) {
    try {
      return ProcessIdentity.closed(IdentityFolder.loadAlone(folder), Clock.systemUTC());
    } catch (IdentityException | GeneralSecurityException e) {
      throw new IllegalStateException(
          fault + " (and this process cannot work for itself: " + e.getMessage() + ")", e);
    }
  }
}
