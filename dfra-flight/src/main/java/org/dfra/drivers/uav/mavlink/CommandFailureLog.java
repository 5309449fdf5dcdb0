package org.dfra.drivers.uav.mavlink;

import com.google.errorprone.annotations.concurrent.GuardedBy;
import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Text;

/**
 * Commands that the vehicle has not executed, and the autopilot's status texts about them. Safe for
 * use by several threads.
 */
final class CommandFailureLog {

  private static final int WARNING = 4;

  /**
   * A status text received within this time before a rejection counts as its reason, nanoseconds.
   */
  private static final long TOGETHER = 2_000_000_000L;

  private final String module;
  private final Ticker ticker;

  @GuardedBy("this")
  private String last = "none";

  @GuardedBy("this")
  private String text = "none";

  @GuardedBy("this")
  private long textNanos;

  CommandFailureLog(String module, Ticker ticker) {
    this.module = module;
    this.ticker = ticker;
    this.textNanos = ticker.nanos() - 2 * TOGETHER;
  }

  /** The autopilot has sent a status text. */
  synchronized void addStatusText(Text statusText) {
    if (statusText.severity() <= WARNING) {
      text = statusText.text();
      textNanos = ticker.nanos();
    }
  }

  /** A command was not executed. */
  synchronized CommandFailedException add(
      String commandName, MavlinkCommand step, CommandResult result) {
    boolean hasReason =
        result.outcome() == CommandResult.CommandOutcome.REJECTED
            && ticker.nanos() - textNanos < TOGETHER;
    last =
        module
            + " did not execute "
            + commandName
            + ": "
            + step.name()
            + " "
            + result
            + (hasReason ? " (the autopilot said: " + text + ")" : "")
            + remedy(result);
    return new CommandFailedException(last);
  }

  private static String remedy(CommandResult result) {
    return switch (result.outcome()) {
      case TIMED_OUT, LINK_LOST -> "; check with flight() whether it was executed";
      case REJECTED -> result.isTemporary() ? "; give the command again in a while" : "";
      case ACCEPTED -> "";
    };
  }

  /** The last command that was not executed. */
  synchronized String last() {
    return last;
  }

  /** The autopilot's last warning. */
  synchronized String text() {
    return text;
  }
}
