package org.dfra.drivers.uav.mavlink;

import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Text;

/**
 * What the vehicle has not obeyed, and what its autopilot has said about it. Safe for use by
 * several threads.
 */
final class CommandFailureLog {

  private static final int WARNING = 4;

  /** A text that came this long before a refusal is taken for its reason, nanoseconds. */
  private static final long TOGETHER = 2_000_000_000L;

  private final String module;
  private final Ticker ticker;
  private String last = "none"; // guarded by this
  private String text = "none"; // guarded by this
  private long textNanos; // guarded by this

  CommandFailureLog(String module, Ticker ticker) {
    this.module = module;
    this.ticker = ticker;
    this.textNanos = ticker.nanos() - 2 * TOGETHER;
  }

  /** The autopilot has said something. */
  synchronized void addStatusText(Text statusText) {
    if (statusText.severity() <= WARNING) {
      text = statusText.text();
      textNanos = ticker.nanos();
    }
  }

  /** An order was not obeyed. */
  synchronized CommandFailedException add(
      String commandName, MavlinkCommand step, CommandResult result) {
    boolean hasReason =
        result.outcome() == CommandResult.CommandOutcome.REJECTED
            && ticker.nanos() - textNanos < TOGETHER;
    last =
        module
            + " has not obeyed "
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
      case TIMED_OUT, LINK_LOST -> "; look at flight() whether it has done so all the same";
      case REJECTED -> result.isTemporary() ? "; give the command again in a while" : "";
      case ACCEPTED -> "";
    };
  }

  /** The last that was not obeyed. */
  synchronized String last() {
    return last;
  }

  /** The autopilot's last warning. */
  synchronized String text() {
    return text;
  }
}
