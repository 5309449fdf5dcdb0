package org.dfra.drivers.link;

import java.time.Duration;
import org.dfra.core.module.Examinations.Finding;
import org.dfra.core.module.LatestReading;

/** What can be examined and mended on any link: whether it is open, and that it is opened anew. */
public final class LinkExamination {

  private static final String OPENING = "opening";
  private static final Duration REOPENING = Duration.ofSeconds(10);

  private final LinkKeeper keeper;
  private final Heard heard;

  /** A sign from the device. */
  @FunctionalInterface
  public interface Sign {

    /**
     * Waits for one.
     *
     * @param good what is found when it comes
     */
    Finding await(String good) throws InterruptedException;
  }

  /**
   * @param heard counts the openings, besides what the device says
   */
  public LinkExamination(LinkKeeper keeper, Heard heard) {
    this.keeper = keeper;
    this.heard = heard;
  }

  /** The link was opened; whoever is told so by the keeper tells it. */
  public void opened() {
    heard.count(OPENING);
  }

  /** Whether the link is open. */
  public Finding link() {
    return keeper.isOpen()
        ? new Finding(true, "the link is open")
        : new Finding(false, "the link is not open: " + keeper.trouble());
  }

  /**
   * Has the link closed and opened again, and waits for a sign.
   *
   * @param who gives the sign: {@code device}
   */
  public Finding reopen(String who, Sign sign) throws InterruptedException {
    long before = heard.sofar(OPENING);
    keeper.reopen();
    return heard.await(OPENING, before, REOPENING)
        ? sign.await("the link was closed and opened again, and the " + who + " speaks")
        : new Finding(
            false,
            "the link could not be opened again within "
                + LatestReading.seconds(REOPENING)
                + ": "
                + keeper.trouble());
  }
}
