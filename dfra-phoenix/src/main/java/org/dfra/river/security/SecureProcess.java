package org.dfra.river.security;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.time.Clock;
import java.time.InstantSource;
import java.util.Objects;
import java.util.Optional;
import org.dfra.core.audit.AuditEvent;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.core.audit.AuditSettings;
import org.dfra.core.audit.AuditTrail;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.IdentityFolder;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.transport.CurrentIdentity;
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
   * Installs what the system property {@value #PROPERTY} names, if it is set. For the main methods
   * of robots' processes.
   *
   * @param stream name of this process's audit trail
   * @throws IllegalStateException if there is an identity, and not even a robot's own key with
   *     which it could run closed: it must not run at all
   */
  public static Installed installFromProperty(String stream) {
    @Nullable String folder = System.getProperty(PROPERTY);
    return folder == null ? Installed.OPEN : install(Path.of(folder), stream);
  }

  /**
   * Installs an identity, before anything is exported or called.
   *
   * @param folder {@code security} in the state folder
   * @param stream name of this process's audit trail
   * @throws IllegalStateException if there is an identity that cannot be used, and not even a
   *     robot's own key with which the process could run closed: it must not run at all
   */
  public static synchronized Installed install(Path folder, String stream) {
    if (installed != null) {
      return installed;
    }
    Installed made =
        IdentityFolder.isJoined(folder) ? installMember(folder, stream, false) : Installed.OPEN;
    installed = made;
    return made;
  }

  /**
   * Installs the identity of a command, which serves nobody and has no audit trail.
   *
   * @param folder {@code security} in the state folder
   * @param believesExpired whether robots with an expired certificate are called too, as only
   *     stopping them needs
   * @throws IllegalStateException if there is an identity that cannot be used
   */
  public static synchronized Installed installForCommand(Path folder, boolean believesExpired) {
    if (installed == null) {
      installed =
          IdentityFolder.isJoined(folder)
              ? installMember(folder, "", believesExpired)
              : Installed.OPEN;
    }
    return installed;
  }

  private static Installed installMember(Path folder, String stream, boolean believesExpired) {
    ProcessIdentity identity;
    SecurityMode mode = SecurityMode.SECURE;
    String fault = "";
    try {
      identity =
          ProcessIdentity.of(
              IdentityFolder.load(folder), folder, believesExpired, Clock.systemUTC());
    } catch (IdentityException | IOException | GeneralSecurityException e) {
      mode = SecurityMode.CLOSED;
      fault = Objects.toString(e.getMessage(), e.toString());
      identity = closed(folder, fault);
    }
    Optional<AuditTrail> trail =
        stream.isEmpty() ? Optional.empty() : trail(folder, stream, identity);
    trail.ifPresent(identity::audit);
    CurrentIdentity.setForProcess(identity.identity());
    SecurityWatch.start(folder, identity, trail);
    if (mode == SecurityMode.CLOSED) {
      LOG.error("This process works for its own robot only: {}", fault);
    }
    SecurityMode entered = mode;
    String reason = fault;
    trail.ifPresent(it -> it.record(AuditEvent.processStarted(entered, reason)));
    return new Installed(
        mode, identity.identity().member().toString(), identity.identity().robot(), fault);
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

  private static Optional<AuditTrail> trail(Path folder, String stream, ProcessIdentity identity) {
    Path state = Objects.requireNonNull(folder.toAbsolutePath().getParent());
    AuditTrail trail =
        new AuditTrail(
            AuditSettings.of(
                AuditSettings.folder(state), stream, identity.identity().member().toString()),
            InstantSource.system());
    try {
      trail.start();
      Runtime.getRuntime().addShutdownHook(new Thread(trail::close, "audit-end"));
      return Optional.of(trail);
    } catch (IOException e) { // a robot works on a full disk too
      LOG.error("Calls of this process are not recorded: {}", e.getMessage());
      return Optional.empty();
    }
  }
}
