package org.dfra.drivers.gps.m12;

import java.time.InstantSource;
import java.util.List;
import java.util.Optional;
import org.dfra.core.module.Diagnostics;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.drivers.gps.GpsReceiverDiagnostics;
import org.dfra.drivers.gps.m12.M12Message.ReceiverIdentification;
import org.dfra.drivers.gps.m12.M12Message.TimeRaim;
import org.dfra.module.Precondition;

/**
 * Tests and recoveries of the receiver, besides {@link GpsReceiverDiagnostics}:
 *
 * <ul>
 *   <li>test {@code identification}: the receiver answers {@code @@Cj} within 3 s
 *   <li>test {@code antenna}: the antenna's state in the last position frame
 *   <li>test {@code integrity}: the result of time RAIM ({@code @@Hn}, {@code @@En}) for the
 *       satellites
 *   <li>recovery {@code reinitialise}: the receiver is reset to its defaults ({@code @@Cf}) and
 *       configured again
 *   <li>recovery {@code set_time}: sends date and time to the receiver ({@code @@Gb}), which
 *       shortens the first satellite acquisition; a receiver that tracks satellites ignores it
 * </ul>
 */
final class M12Diagnostics {

  /** Source: Motorola Oncore M12+ user's guide, technical characteristics. */
  static final List<Precondition> PRECONDITIONS =
      List.of(
          new Precondition("temperature of the receiver", -40, 85, "°C"),
          new Precondition("relative humidity, not condensing", 0, 95, "%"),
          new Precondition("altitude", -1000, 18_000, "m"),
          new Precondition("speed", 0, 515, "m/s"),
          new Precondition("satellites in view of the antenna", 4, 12, ""));

  private final GpsReceiverDiagnostics receiver;
  private final M12Protocol protocol;
  private final InstantSource clock;

  M12Diagnostics(GpsReceiverDiagnostics receiver, M12Protocol protocol, InstantSource clock) {
    this.receiver = receiver;
    this.protocol = protocol;
    this.clock = clock;
  }

  void declareIn(Diagnostics examinations) {
    examinations.addTest("identification", this::identification);
    examinations.addTest("antenna", this::antenna);
    examinations.addTest("integrity", this::integrity);
    examinations.addRecovery("reinitialise", this::reinitialise);
    examinations.addRecovery("set_time", this::setTime);
  }

  private DiagnosticFinding identification() throws InterruptedException {
    return receiver.ask(
        M12Commands.identification(),
        "Cj",
        "@@Cj",
        () ->
            "it says it is "
                + protocol
                    .identification()
                    .map(ReceiverIdentification::model)
                    .orElse("a receiver"));
  }

  private DiagnosticFinding antenna() {
    Optional<ReceiverStatus> last = protocol.status();
    if (last.isEmpty()) {
      return new DiagnosticFinding(
          false, "no @@Ha has come, and only it reports the antenna; eight channels have none");
    }
    return switch (last.get().antenna()) {
      case OK ->
          new DiagnosticFinding(true, "the antenna is connected and draws the right current");
      case OVER_CURRENT ->
          new DiagnosticFinding(
              false, "the antenna draws too much current: look for a short circuit");
      case UNDER_CURRENT ->
          new DiagnosticFinding(
              false, "the antenna draws too little current: it is not connected, or passive");
      case NO_VOLTAGE ->
          new DiagnosticFinding(false, "the receiver has no voltage to give its antenna");
    };
  }

  private DiagnosticFinding integrity() {
    return protocol
        .timeRaim()
        .map(raim -> new DiagnosticFinding(raim.solution() == TimeRaim.Solution.OK, raim.inWords()))
        .orElse(new DiagnosticFinding(false, "the receiver has sent neither @@Hn nor @@En"));
  }

  private DiagnosticFinding reinitialise() throws InterruptedException {
    DiagnosticFinding done = receiver.ask(M12Commands.defaults(), "Cf", "@@Cf", () -> "");
    return done.passed()
        ? receiver.solution("the receiver was set to its defaults and configured again, and sends")
        : done;
  }

  private DiagnosticFinding setTime() throws InterruptedException {
    byte[] command = M12Commands.time(clock.instant());
    return receiver.ask(
        command,
        "Gb",
        "@@Gb",
        () ->
            "the receiver's clock shows "
                + protocol
                    .clock()
                    .map(reported -> reported.time().toInstant().toString())
                    .orElse("?"));
  }
}
