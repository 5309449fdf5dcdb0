package org.dfra.drivers.uav.mavlink;

import org.dfra.drivers.link.Ticker;
import org.dfra.drivers.uav.mavlink.MavlinkMessage.Text;

/**
 * What the vehicle has not obeyed, and what its autopilot has said about it. Safe for use by
 * several threads.
 */
final class FlightRefusals {

  private static final int WARNING = 4;

  /** A text that came this long before a refusal is taken for its reason, nanoseconds. */
  private static final long TOGETHER = 2_000_000_000L;

  private final String module;
  private final Ticker ticker;
  private String last = "none"; // guarded by this
  private String text = "none"; // guarded by this
  private long textNanos; // guarded by this

  FlightRefusals(String module, Ticker ticker) {
    this.module = module;
    this.ticker = ticker;
    this.textNanos = ticker.nanos() - 2 * TOGETHER;
  }

  /** The autopilot has said something. */
  synchronized void heard(Text said) {
    if (said.severity() <= WARNING) {
      text = said.text();
      textNanos = ticker.nanos();
    }
  }

  /** An order was not obeyed. */
  synchronized CommandNotObeyedException add(
      String order, MavlinkCommand step, CommandResult result) {
    boolean hasReason =
        result.end() == CommandResult.End.REFUSED && ticker.nanos() - textNanos < TOGETHER;
    last =
        module
            + " has not obeyed "
            + order
            + ": "
            + step.name()
            + " "
            + result
            + (hasReason ? " (the autopilot said: " + text + ")" : "")
            + remedy(result);
    return new CommandNotObeyedException(last);
  }

  private static String remedy(CommandResult result) {
    return switch (result.end()) {
      case UNANSWERED, LOST -> "; look at flight() whether it has done so all the same";
      case REFUSED -> result.isForNow() ? "; give the command again in a while" : "";
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
