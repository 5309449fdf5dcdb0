package org.dfra.drivers.laser.lms;

import java.time.Duration;
import java.util.List;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.dfra.core.module.Examinations;
import org.dfra.core.module.Examinations.Finding;
import org.dfra.core.module.LatestReading;
import org.dfra.drivers.device.DeviceLine;
import org.dfra.drivers.laser.lms.LmsMessage.LmsError;
import org.dfra.module.Precondition;
import org.jspecify.annotations.Nullable;

/**
 * What can be examined and mended on the laser, besides {@link DeviceLine}. A stream is interrupted
 * while the laser is asked.
 *
 * <ul>
 *   <li>test {@code status}: it tells how it is (31 hex), and is sound: no defect, no error, laser
 *       on, window clean, values plausible
 *   <li>test {@code type}: it tells what it is (3A hex)
 *   <li>test {@code errors}: it tells which errors it remembers (32 hex), none of them present
 *   <li>recovery {@code reset}: it begins anew, as if it had been switched off and on, and is told
 *       anew what to do; takes up to a minute
 *   <li>recovery {@code renegotiate}: it is searched at all speeds and told anew what to do
 * </ul>
 */
final class LmsExamination {

  /** A scan that was understood has come. */
  static final String SCAN = "understood scan";

  /** Source: technical description of the LMS 200; none of them was tried. */
  static final List<Precondition> PRECONDITIONS =
      List.of(
          new Precondition("temperature of the air around it", 0, 50, "°C"),
          new Precondition("supply voltage", 20.4, 27.6, "V"));

  /** Stopping a stream at 9600 baud, asking, and trying again twice. */
  private static final Duration ANSWER = Duration.ofSeconds(8);

  private static final Duration ANEW = Duration.ofSeconds(30);
  private static final Duration WOKEN = Duration.ofSeconds(90);

  private final DeviceLine line;
  private final LmsProtocol protocol;
  private final LmsRest rest;

  // what the laser last told; written by the reader, read by anyone
  private volatile @Nullable LmsStatus status;
  private volatile LmsMessage.@Nullable Errors errors;
  private volatile String type = "a laser that has not told its type";

  LmsExamination(DeviceLine line, LmsProtocol protocol, LmsRest rest) {
    this.line = line;
    this.protocol = protocol;
    this.rest = rest;
  }

  void declareIn(Examinations examinations) {
    examinations.test("status", () -> asked(LmsRequest.STATUS, "B1", this::status));
    examinations.test("type", () -> asked(LmsRequest.TYPE, "BA", this::type));
    examinations.test("errors", () -> asked(LmsRequest.ERRORS, "B2", this::errors));
    examinations.recovery("reset", () -> anew(protocol::reset, WOKEN, "was reset"));
    examinations.recovery("renegotiate", () -> anew(protocol::renegotiate, ANEW, "was searched"));
  }

  /** Takes what the laser told. */
  void told(LmsMessage.Telegram telegram) {
    if (telegram instanceof LmsStatus now) {
      status = now;
    } else if (telegram instanceof LmsMessage.Errors now) {
      errors = now;
    } else if (telegram instanceof LmsMessage.Type now) {
      type = now.type();
    }
  }

  private Finding asked(LmsRequest request, String answer, Supplier<Finding> finding)
      throws InterruptedException {
    Finding link = line.link();
    if (!link.passed()) {
      return link;
    }
    long before = line.heard().sofar(answer);
    protocol.inquire(request);
    return line.heard().await(answer, before, ANSWER)
        ? finding.get()
        : new Finding(
            false,
            "it was asked "
                + request.kind().words()
                + " and has not answered within "
                + LatestReading.seconds(ANSWER));
  }

  private Finding status() {
    LmsStatus told = status;
    return told == null
        ? new Finding(false, "it has told nothing that can be understood")
        : new Finding(told.isSound(), told.inWords());
  }

  private Finding type() {
    return new Finding(true, "it says it is " + type);
  }

  private Finding errors() {
    LmsMessage.Errors told = errors;
    List<LmsError> all = told == null ? List.of() : told.errors();
    String words =
        all.isEmpty()
            ? "it remembers no errors"
            : "it remembers "
                + all.stream().map(LmsError::inWords).collect(Collectors.joining(", "));
    return new Finding(told != null && all.stream().noneMatch(LmsError::isPresent), words);
  }

  private Finding anew(Runnable order, Duration patience, String done) throws InterruptedException {
    Finding link = line.link();
    if (!link.passed()) {
      return link;
    }
    boolean resets = done.equals("was reset");
    if (resets && !protocol.isPrepared()) {
      return new Finding(
          false, "the laser does not answer, so it cannot be reset; switch it off and on");
    }
    String sign = resets ? "90" : LmsProtocol.PREPARED;
    long before = line.heard().sofar(sign);
    rest.used();
    order.run();
    if (!line.heard().await(sign, before, patience)) {
      return new Finding(
          false,
          "the laser " + done + " but has not answered within " + LatestReading.seconds(patience));
    }
    rest.used();
    return line.heard().await(SCAN, line.heard().sofar(SCAN), ANEW)
        ? new Finding(true, "the laser " + done + " and told anew what to do, and sends scans")
        : new Finding(false, "the laser " + done + " but no scan has come");
  }
}
