package org.dfra.drivers.gps;

import static org.dfra.core.module.LatestReading.seconds;

import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.dfra.core.module.Diagnostics;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.drivers.gps.GpsReceiverProtocol.SatelliteInView;
import org.dfra.drivers.link.EventCounter;
import org.dfra.drivers.link.LinkDiagnostics;
import org.dfra.drivers.link.LinkKeeper;

/**
 * Tests and recoveries of every receiver:
 *
 * <ul>
 *   <li>test {@code link}: the link is open
 *   <li>test {@code positions}: solutions arrive at the expected rate
 *   <li>test {@code satellites}: which satellites are in view, with what signal, and which are used
 *   <li>recovery {@code reopen_link}: the link is closed and reopened, and the receiver sends data
 * </ul>
 *
 * <p>The other methods are for the drivers' own diagnostics.
 */
public final class GpsReceiverDiagnostics {

  /** The receiver has reported a solution, with a position or without. */
  static final String SOLUTION = "solution";

  /** Minimum number of satellites for a position. */
  private static final int ENOUGH = 4;

  private static final Duration ANSWER = Duration.ofSeconds(3);

  private final LinkDiagnostics link;
  private final Consumer<byte[]> sender;
  private final EventCounter eventCounter;
  private final ReportingPeriod reportingPeriod;
  private final Supplier<List<SatelliteInView>> satellites;

  GpsReceiverDiagnostics(
      LinkKeeper keeper,
      Consumer<byte[]> sender,
      EventCounter received,
      ReportingPeriod reportingPeriod,
      Supplier<List<SatelliteInView>> satellites) {
    this.link = new LinkDiagnostics(keeper, received);
    this.sender = sender;
    this.eventCounter = received;
    this.reportingPeriod = reportingPeriod;
    this.satellites = satellites;
  }

  void declareIn(Diagnostics examinations) {
    examinations.addTest("link", this::link);
    examinations.addTest("positions", this::positions);
    examinations.addTest("satellites", this::satellites);
    examinations.addRecovery("reopen_link", this::reopenLink);
  }

  /** The link was opened. */
  void opened() {
    link.opened();
  }

  /** Whether the link is open. */
  public DiagnosticFinding link() {
    return link.link();
  }

  /**
   * Sends a query to the receiver over an open link and waits for the answer.
   *
   * @param question the bytes to send
   * @param answer the name of the answer's message
   * @param asked human-readable name of the query: {@code @@Cj}
   * @param good makes the finding when it answers
   */
  public DiagnosticFinding ask(byte[] question, String answer, String asked, Supplier<String> good)
      throws InterruptedException {
    DiagnosticFinding open = link();
    if (!open.passed()) {
      return open;
    }
    long before = eventCounter.total(answer);
    sender.accept(question);
    return eventCounter.await(answer, before, ANSWER)
        ? new DiagnosticFinding(true, good.get())
        : new DiagnosticFinding(
            false, "it has not answered " + asked + " within " + seconds(ANSWER));
  }

  /** Waits for the next solution. */
  public DiagnosticFinding solution(String good) throws InterruptedException {
    Duration patience = reportingPeriod.longestAge();
    return eventCounter.await(SOLUTION, eventCounter.total(SOLUTION), patience)
        ? new DiagnosticFinding(true, good)
        : new DiagnosticFinding(false, "no position frame has come within " + seconds(patience));
  }

  private DiagnosticFinding positions() throws InterruptedException {
    DiagnosticFinding open = link();
    return open.passed() ? solution("the receiver sends position frames") : open;
  }

  private DiagnosticFinding satellites() {
    List<SatelliteInView> seen = satellites.get();
    long used = seen.stream().filter(SatelliteInView::used).count();
    return new DiagnosticFinding(used >= ENOUGH, inWords(seen));
  }

  /** {@code 11 in view, 9 tracked, 9 used: G14 41° up, …}. */
  static String inWords(List<SatelliteInView> seen) {
    if (seen.isEmpty()) {
      return "the receiver has reported no satellites";
    }
    long trackedOnes = seen.stream().filter(SatelliteInView::isTracked).count();
    long used = seen.stream().filter(SatelliteInView::used).count();
    return seen.size()
        + " in view, "
        + trackedOnes
        + " tracked, "
        + used
        + " used: "
        + seen.stream().map(SatelliteInView::toString).collect(Collectors.joining("; "));
  }

  private DiagnosticFinding reopenLink() throws InterruptedException {
    return link.reopen("receiver", this::solution);
  }
}
