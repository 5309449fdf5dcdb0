package org.dfra.drivers.pantilt.ptu;

import java.time.Duration;
import java.util.function.BooleanSupplier;
import java.util.function.Supplier;
import org.dfra.core.module.Diagnostics;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.LatestReading;
import org.dfra.drivers.device.DeviceLink;
import org.dfra.drivers.pantilt.ptu.PtuReply.Refused;
import org.dfra.drivers.pantilt.ptu.PtuReply.Value;
import org.jspecify.annotations.Nullable;

/** Tests and recoveries of the unit, besides those of its link. */
final class PtuDiagnostics {

  private static final Duration ANSWER = Duration.ofSeconds(3);
  private static final Duration RESET = Duration.ofSeconds(60);

  private final DeviceLink deviceLink;
  private final PtuProtocol protocol;
  private final Supplier<@Nullable String> commander;
  private final BooleanSupplier stopped;
  private volatile PtuReply last = new PtuReply.Done(); // before its query was ever answered

  /**
   * @param commander the commander of the unit, null if there is none
   * @param stopped whether it is stopped for an emergency
   */
  PtuDiagnostics(
      DeviceLink line,
      PtuProtocol protocol,
      Supplier<@Nullable String> commander,
      BooleanSupplier stopped) {
    this.deviceLink = line;
    this.protocol = protocol;
    this.commander = commander;
    this.stopped = stopped;
  }

  void declareIn(Diagnostics examinations) {
    examinations.addTest("identification", this::identification);
    examinations.addRecovery("reset_by_moving", this::reset);
  }

  /** The unit has answered; on the reader's thread. */
  void answered(String question, PtuReply reply) {
    last = reply;
    deviceLink.eventCounter().increment(question);
  }

  private DiagnosticFinding identification() throws InterruptedException {
    PtuReply reply = request(PtuCommands.VERSION, ANSWER);
    if (reply instanceof Value value) {
      return new DiagnosticFinding(true, "it says it is " + value.text());
    }
    return unanswered(reply, "V", ANSWER);
  }

  private DiagnosticFinding reset() throws InterruptedException {
    if (stopped.getAsBoolean()) {
      return new DiagnosticFinding(
          false, "it moves the head, which is stopped for an emergency; release it first");
    }
    String someone = commander.get();
    if (someone != null) {
      return new DiagnosticFinding(
          false, "it moves the head, which " + someone + " commands; have its lease closed first");
    }
    PtuReply reply = request(PtuCommands.RESET, RESET);
    return reply instanceof PtuReply.Done
        ? new DiagnosticFinding(true, "the head was turned to its ends and points to 0, 0 now")
        : unanswered(reply, "R", RESET);
  }

  /** Sends a query and waits for the answer; null after the timeout. */
  private @Nullable PtuReply request(String question, Duration patience)
      throws InterruptedException {
    if (!deviceLink.isOpen()) {
      return null;
    }
    long before = deviceLink.eventCounter().total(question);
    protocol.request(question);
    return deviceLink.eventCounter().await(question, before, patience) ? last : null;
  }

  private DiagnosticFinding unanswered(
      @Nullable PtuReply reply, String question, Duration patience) {
    if (!deviceLink.isOpen()) {
      return deviceLink.link();
    }
    return new DiagnosticFinding(
        false,
        reply instanceof Refused refused
            ? "it refuses " + question + ": " + refused.message()
            : "it has not answered " + question + " within " + LatestReading.seconds(patience));
  }
}
