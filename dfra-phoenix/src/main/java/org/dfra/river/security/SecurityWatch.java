package org.dfra.river.security;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.security.GeneralSecurityException;
import java.security.cert.X509CRL;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.locks.LockSupport;
import org.dfra.core.audit.AuditEvent;
import org.dfra.core.config.ConfigurationException;
import org.dfra.core.policy.Policy;
import org.dfra.core.policy.PolicyReplacementException;
import org.dfra.river.identity.IdentityException;
import org.dfra.river.identity.SecurityFiles;
import org.dfra.river.identity.SignedFiles;
import org.dfra.river.security.budget.ProcessBudgets;
import org.dfra.river.security.news.NewsExchange;
import org.dfra.river.security.robot.RobotState;
import org.jspecify.annotations.Nullable;
import org.slf4j.Logger;
import org.slf4j.LoggerFactory;

/**
 * Reads the policy, the list of revoked certificates and delegations again when their files have
 * changed. A file that cannot be used changes nothing: the last good one stays in force. Also has
 * the end of the audit trail signed in each period.
 *
 * <p>Thread: one daemon, {@code dfra-security}, for the life of the process. It looks at the times
 * of two files four times a second, since a folder that is replaced as a whole cannot be watched,
 * and at what the robot's processes share for decisions by the policy.
 */
final class SecurityWatch implements Runnable {

  private static final Logger LOG = LoggerFactory.getLogger(SecurityWatch.class);

  private static final long PERIOD_NANOS = TimeUnit.MILLISECONDS.toNanos(250);

  /** While an operator may answer a request at any moment. */
  private static final long ANSWER_PERIOD_NANOS = TimeUnit.MILLISECONDS.toNanos(100);

  private final Path policyFile;
  private final Path revokedFile;
  private final Path folder;
  private final ProcessIdentity identity;
  private final Parts parts;
  private final Thread thread;

  @GuardedBy("this")
  private List<Object> policyState;

  @GuardedBy("this")
  private List<Object> revokedState;

  @GuardedBy("this")
  private boolean hasSigned;

  @GuardedBy("this")
  private long signed; // by System.nanoTime

  /**
   * What else it tends.
   *
   * @param time null if the identity cannot be used
   * @param robot what a robot's processes share for decisions by the policy; null if this is no
   *     process of a secure robot
   * @param budgets of the process; null if it is no robot's
   */
  record Parts(
      @Nullable KnownTime time, @Nullable RobotState robot, @Nullable ProcessBudgets budgets) {}

  private SecurityWatch(Path folder, ProcessIdentity identity, Parts parts) {
    this.parts = parts;
    this.folder = folder;
    this.thread = new Thread(this, "dfra-security");
    thread.setDaemon(true);
    this.policyFile = folder.resolve(SecurityFiles.POLICY);
    this.revokedFile = folder.resolve(SecurityFiles.REVOKED);
    this.identity = identity;
    this.policyState = state(policyFile);
    this.revokedState = state(revokedFile);
  }

  /** Starts to watch what has just been loaded. */
  static SecurityWatch start(Path folder, ProcessIdentity identity, Parts parts) {
    SecurityWatch watch = new SecurityWatch(folder, identity, parts);
    watch.thread.start();
    return watch;
  }

  /** What changes when a file does; empty if there is none. */
  private static List<Object> state(Path file) {
    try {
      return List.of(Files.getLastModifiedTime(file), Files.size(file));
    } catch (NoSuchFileException e) {
      return List.of();
    } catch (IOException e) {
      LOG.debug("{} cannot be looked at.", file, e);
      return List.of();
    }
  }

  @Override
  public void run() {
    while (true) {
      boolean isAnswerAwaited = lookAtAll();
      LockSupport.parkNanos(this, isAnswerAwaited ? ANSWER_PERIOD_NANOS : PERIOD_NANOS);
    }
  }

  /** Has it look soon. Returns at once. */
  void wake() {
    LockSupport.unpark(thread);
  }

  /** Looks now. */
  void look() {
    boolean unused = lookAtAll();
  }

  /** Returns whether an operator may answer a request at any moment. */
  private synchronized boolean lookAtAll() {
    try {
      lookAtRevoked();
      lookAtPolicy();
      identity.reloadDelegations();
      signHeadIfDue();
      @Nullable KnownTime time = parts.time();
      if (time != null) {
        time.keep();
      }
      @Nullable RobotState robot = parts.robot();
      return robot != null && robot.look(identity.policy().policy().needsPosition());
    } catch (RuntimeException | Error e) { // without this thread, no revocation would be noticed
      LOG.error("A change of {} was not noticed.", folder, e);
      return false;
    }
  }

  /** Soon after the audit trail has begun, and then in each period. */
  @GuardedBy("this")
  private void signHeadIfDue() {
    Optional<NewsExchange> news = SecureProcess.news();
    if (news.isEmpty() || !identity.hasHead()) {
      return;
    }
    long now = System.nanoTime();
    if (!hasSigned || now - signed >= NewsExchange.HEADS_PERIOD.toNanos()) {
      hasSigned = true;
      signed = now;
      news.get().publishHead(identity::head);
    }
  }

  @GuardedBy("this")
  private void lookAtRevoked() {
    List<Object> now = state(revokedFile);
    if (now.isEmpty() || now.equals(revokedState)) {
      return;
    }
    revokedState = now;
    try {
      X509CRL list =
          SignedFiles.revocations(
              SecurityFiles.read(revokedFile), identity.authority(), revokedFile.toString());
      if (identity.revoked().replace(list)) {
        @Nullable KnownTime time = parts.time();
        if (time != null) {
          time.learn(list);
        }
        long number = identity.revoked().number().longValue();
        LOG.info("The list {} of revoked certificates is in force.", number);
        identity.record(AuditEvent.revocationReceived(number, revokedFile.toString(), ""));
      }
    } catch (IdentityException | GeneralSecurityException e) {
      LOG.error("The former list of revoked certificates stays in force: {}", e.getMessage());
    }
  }

  @GuardedBy("this")
  private void lookAtPolicy() {
    List<Object> now = state(policyFile);
    if (identity.isClosed() || now.isEmpty() || now.equals(policyState)) {
      return;
    }
    policyState = now;
    try {
      Optional<Policy> next = StoredPolicy.of(folder, identity.authority());
      if (next.isPresent() && identity.policy().replace(next.get())) {
        LOG.info("{} is in force.", next.get());
        @Nullable ProcessBudgets budgets = parts.budgets();
        if (budgets != null) {
          budgets.policyChanged();
        }
        identity.record(AuditEvent.policyReplaced(next.get().version(), policyFile.toString()));
      }
    } catch (IOException | ConfigurationException | PolicyReplacementException e) {
      LOG.error(
          "{} stays in force: {}", identity.policy().policy(), String.valueOf(e.getMessage()));
    }
  }
}
