package org.dfra.drivers.link;

import java.time.Duration;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.LatestReading;

/** The test and the recovery of any link: whether it is open, and reopening it. */
public final class LinkDiagnostics {

  private static final String OPENING = "opening";
  private static final Duration REOPENING = Duration.ofSeconds(10);

  private final LinkKeeper keeper;
  private final EventCounter eventCounter;

  /** A sign of life from the device. */
  @FunctionalInterface
  public interface Sign {

    /**
     * Waits for a sign of life.
     *
     * @param good text of the finding when it arrives
     */
    DiagnosticFinding await(String good) throws InterruptedException;
  }

  /**
   * @param eventCounter counts the openings, besides the device's messages
   */
  public LinkDiagnostics(LinkKeeper keeper, EventCounter eventCounter) {
    this.keeper = keeper;
    this.eventCounter = eventCounter;
  }

  /** The link was opened; called by the link keeper's handler. */
  public void opened() {
    eventCounter.increment(OPENING);
  }

  /** Whether the link is open. */
  public DiagnosticFinding link() {
    return keeper.isOpen()
        ? new DiagnosticFinding(true, "the link is open")
        : new DiagnosticFinding(false, "the link is not open: " + keeper.fault());
  }

  /**
   * Closes and reopens the link, and waits for a sign of life.
   *
   * @param deviceName name of the device that gives the sign: {@code device}
   */
  public DiagnosticFinding reopen(String deviceName, Sign sign) throws InterruptedException {
    long before = eventCounter.total(OPENING);
    keeper.reopen();
    return eventCounter.await(OPENING, before, REOPENING)
        ? sign.await("the link was closed and opened again, and the " + deviceName + " speaks")
        : new DiagnosticFinding(
            false,
            "the link could not be opened again within "
                + LatestReading.seconds(REOPENING)
                + ": "
                + keeper.fault());
  }
}
