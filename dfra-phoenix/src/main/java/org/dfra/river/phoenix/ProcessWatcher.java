package org.dfra.river.phoenix;

import java.time.Duration;
import org.dfra.river.phoenix.host.ClassArchive;
import org.dfra.river.phoenix.restart.CrashHistory.ProcessExit;
import org.jspecify.annotations.Nullable;

/**
 * Watches the processes of groups: reports their exits, and enforces the timeouts for their reports
 * and their exits.
 */
final class ProcessWatcher {

  /** Longer than any process runs. */
  private static final Duration FOREVER = Duration.ofDays(36500);

  /** Time that a process has for its exit beyond the timeout for its own unexports. */
  private static final Duration EXIT_MARGIN = Duration.ofSeconds(2);

  private final DaemonExecutors threads;
  private final Duration groupTimeout;
  private final Duration unexportTimeout;

  /**
   * @param groupTimeout the longest wait for the report of a process
   * @param unexportTimeout the longest wait of a process for its running calls before its exit
   */
  ProcessWatcher(DaemonExecutors threads, Duration groupTimeout, Duration unexportTimeout) {
    this.threads = threads;
    this.groupTimeout = groupTimeout;
    this.unexportTimeout = unexportTimeout;
  }

  /** The owner of a process. */
  interface ProcessOwner {

    /** Records that one of its processes exited. */
    void onProcessExit(ProcessIdentity process, ProcessExit exit);

    /** Kills one of its processes, if that has still not reported. */
    void killUnlessReported(ProcessIdentity process);
  }

  /**
   * Reports the exit of a process to its owner.
   *
   * @param child the process, if this phoenix started it
   */
  void reportExit(ProcessOwner owner, ProcessIdentity identity, @Nullable Process child) {
    if (child != null) {
      child
          .onExit()
          .thenAccept(
              ended -> {
                ClassArchive.recordExit(ended.exitValue()); // before its group starts again
                owner.onProcessExit(identity, ProcessExit.of(ended.exitValue()));
              });
    } else {
      threads.execute(
          () -> {
            if (identity.awaitExit(FOREVER)) {
              owner.onProcessExit(
                  identity,
                  ProcessExit.unrequested(
                      "ended (exit code unknown: it was a former phoenix's child)"));
            }
          });
    }
  }

  /** Lets its owner kill a process that does not report within the group's timeout. */
  void limitReport(ProcessOwner owner, ProcessIdentity process) {
    threads.after(groupTimeout, () -> owner.killUnlessReported(process));
  }

  /** Kills a process that announced its exit, if it has not exited after a while. */
  void killIfLingering(ProcessIdentity process) {
    threads.after(unexportTimeout.plus(EXIT_MARGIN), () -> process.kill());
  }
}
