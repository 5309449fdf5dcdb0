package org.dfra.drivers.laser.lms;

import java.time.Duration;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.dfra.core.module.Diagnostics;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.LatestReading;
import org.dfra.drivers.device.DeviceLink;
import org.dfra.drivers.laser.lms.LmsMessage.LmsError;
import org.dfra.module.Precondition;
import org.jspecify.annotations.Nullable;

/**
 * Tests and recoveries of the laser, besides those of {@link DeviceLink}. A stream is interrupted
 * during a query.
 *
 * <ul>
 *   <li>test {@code status}: it reports its status (31 hex) and is healthy: no defect, no error,
 *       laser on, window clean, values plausible
 *   <li>test {@code type}: it reports its type (3A hex)
 *   <li>test {@code errors}: it reports its stored errors (32 hex), none of them present
 *   <li>recovery {@code reset}: it is restarted, like switching it off and on, and configured
 *       again; takes up to a minute
 *   <li>recovery {@code renegotiate}: the driver searches for it at all baud rates and configures
 *       it again
 * </ul>
 */
final class LmsDiagnostics {

  /** A scan that could be interpreted has been received. */
  static final String SCAN = "understood scan";

  /** Source: technical description of the LMS 200; none of them was tested. */
  static final List<Precondition> PRECONDITIONS =
      List.of(
          new Precondition("temperature of the air around it", 0, 50, "°C"),
          new Precondition("supply voltage", 20.4, 27.6, "V"));

  /** Time to stop a stream at 9600 baud, send a query, and retry twice. */
  private static final Duration ANSWER = Duration.ofSeconds(8);

  private static final Duration RENEGOTIATION = Duration.ofSeconds(30);
  private static final Duration WOKEN = Duration.ofSeconds(90);

  private final DeviceLink deviceLink;
  private final LmsProtocol protocol;
  private final LmsIdlePolicy idlePolicy;

  // the laser's last reports; written by the reader, read by any thread
  private volatile @Nullable LmsStatus status;
  private volatile LmsMessage.@Nullable ErrorsReply errors;
  private volatile String type = "a laser that has not reported its type";

  LmsDiagnostics(DeviceLink line, LmsProtocol protocol, LmsIdlePolicy rest) {
    this.deviceLink = line;
    this.protocol = protocol;
    this.idlePolicy = rest;
  }

  void declareIn(Diagnostics examinations) {
    examinations.addTest("status", () -> asked(LmsRequest.STATUS, "B1", this::status));
    examinations.addTest("type", () -> asked(LmsRequest.TYPE, "BA", this::type));
    examinations.addTest("errors", () -> asked(LmsRequest.ERRORS, "B2", this::errors));
    examinations.addRecovery("reset", () -> restart(protocol::reset, WOKEN, "was reset"));
    examinations.addRecovery(
        "renegotiate", () -> restart(protocol::renegotiate, RENEGOTIATION, "was searched"));
  }

  /** Processes a telegram from the laser. */
  void telegramReceived(LmsMessage.Telegram telegram) {
    if (telegram instanceof LmsStatus now) {
      status = now;
    } else if (telegram instanceof LmsMessage.ErrorsReply now) {
      errors = now;
    } else if (telegram instanceof LmsMessage.TypeReply now) {
      type = now.type();
    }
  }

  private DiagnosticFinding asked(
      LmsRequest request, String answer, Supplier<DiagnosticFinding> finding)
      throws InterruptedException {
    DiagnosticFinding link = deviceLink.link();
    if (!link.passed()) {
      return link;
    }
    long before = deviceLink.eventCounter().total(answer);
    protocol.enqueue(request);
    return deviceLink.eventCounter().await(answer, before, ANSWER)
        ? finding.get()
        : new DiagnosticFinding(
            false,
            "it was asked "
                + request.kind().words()
                + " and has not answered within "
                + LatestReading.seconds(ANSWER));
  }

  private DiagnosticFinding status() {
    LmsStatus reported = status;
    return reported == null
        ? new DiagnosticFinding(false, "it has sent nothing that can be decoded")
        : new DiagnosticFinding(reported.isSound(), reported.inWords());
  }

  private DiagnosticFinding type() {
    return new DiagnosticFinding(true, "it says it is " + type);
  }

  private DiagnosticFinding errors() {
    LmsMessage.ErrorsReply reported = errors;
    List<LmsError> all = reported == null ? List.of() : reported.errors();
    String words =
        all.isEmpty()
            ? "it remembers no errors"
            : "it remembers "
                + all.stream().map(LmsError::inWords).collect(Collectors.joining(", "));
    return new DiagnosticFinding(
        reported != null && all.stream().noneMatch(LmsError::isPresent), words);
  }

  private DiagnosticFinding restart(Runnable command, Duration patience, String done)
      throws InterruptedException {
    DiagnosticFinding link = deviceLink.link();
    if (!link.passed()) {
      return link;
    }
    boolean resets = done.equals("was reset");
    if (resets && !protocol.isConfigured()) {
      return new DiagnosticFinding(
          false, "the laser does not answer, so it cannot be reset; switch it off and on");
    }
    String sign = resets ? "90" : LmsProtocol.PREPARED;
    long before = deviceLink.eventCounter().total(sign);
    idlePolicy.used();
    command.run();
    if (!deviceLink.eventCounter().await(sign, before, patience)) {
      return new DiagnosticFinding(
          false,
          "the laser " + done + " but has not answered within " + LatestReading.seconds(patience));
    }
    idlePolicy.used();
    return deviceLink
            .eventCounter()
            .await(SCAN, deviceLink.eventCounter().total(SCAN), RENEGOTIATION)
        ? new DiagnosticFinding(
            true, "the laser " + done + " and configured again, and sends scans")
        : new DiagnosticFinding(false, "the laser " + done + " but no scan has come");
  }
}
