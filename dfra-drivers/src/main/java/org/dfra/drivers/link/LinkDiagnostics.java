package org.dfra.drivers.link;

import java.time.Duration;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.core.module.LatestReading;

/** What can be examined and mended on any link: whether it is open, and that it is opened anew. */
public final class LinkDiagnostics {

  private static final String OPENING = "opening";
  private static final Duration REOPENING = Duration.ofSeconds(10);

  private final LinkKeeper keeper;
  private final EventCounter eventCounter;

  /** A sign from the device. */
  @FunctionalInterface
  public interface Sign {

    /**
     * Waits for one.
     *
     * @param good what is found when it comes
     */
    DiagnosticFinding await(String good) throws InterruptedException;
  }

  /**
   * @param eventCounter counts the openings, besides what the device says
   */
  public LinkDiagnostics(LinkKeeper keeper, EventCounter eventCounter) {
    this.keeper = keeper;
    this.eventCounter = eventCounter;
  }

  /** The link was opened; whoever is told so by the keeper tells it. */
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
   * Has the link closed and opened again, and waits for a sign.
   *
   * @param deviceName gives the sign: {@code device}
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
