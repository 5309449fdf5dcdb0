package org.dfra.drivers.gps;

import static org.dfra.core.module.LatestReading.seconds;

import java.time.Duration;
import java.util.List;
import java.util.function.Consumer;
import java.util.function.Supplier;
import java.util.stream.Collectors;
import org.dfra.core.module.Examinations;
import org.dfra.core.module.Examinations.Finding;
import org.dfra.drivers.link.Heard;
import org.dfra.drivers.link.LinkExamination;
import org.dfra.drivers.link.LinkKeeper;

/**
 * What can be examined and mended on every receiver:
 *
 * <ul>
 *   <li>test {@code link}: the link is open
 *   <li>test {@code positions}: solutions come at the expected rate
 *   <li>test {@code satellites}: which ones it sees, how well, and which ones it uses
 *   <li>recovery {@code reopen_link}: the link is closed and opened again, and the receiver speaks
 * </ul>
 *
 * <p>The rest is for the drivers' own examinations.
 */
public final class ReceiverExamination {

  /** The receiver told a solution, with a position or without. */
  static final String SOLUTION = "solution";

  /** Satellites that a position takes. */
  private static final int ENOUGH = 4;

  private static final Duration ANSWER = Duration.ofSeconds(3);

  private final LinkExamination link;
  private final Consumer<byte[]> sender;
  private final Heard heard;
  private final Pace pace;
  private final Supplier<List<SatelliteInView>> satellites;

  ReceiverExamination(
      LinkKeeper keeper,
      Consumer<byte[]> sender,
      Heard heard,
      Pace pace,
      Supplier<List<SatelliteInView>> satellites) {
    this.link = new LinkExamination(keeper, heard);
    this.sender = sender;
    this.heard = heard;
    this.pace = pace;
    this.satellites = satellites;
  }

  void declareIn(Examinations examinations) {
    examinations.test("link", this::link);
    examinations.test("positions", this::positions);
    examinations.test("satellites", this::satellites);
    examinations.recovery("reopen_link", this::reopenLink);
  }

  /** The link was opened. */
  void opened() {
    link.opened();
  }

  /** Whether the link is open. */
  public Finding link() {
    return link.link();
  }

  /**
   * Asks the receiver for something, over an open link.
   *
   * @param question the bytes to send
   * @param answer the name of the message that answers
   * @param asked what was asked, for people: {@code @@Cj}
   * @param good what is found when it answers
   */
  public Finding ask(byte[] question, String answer, String asked, Supplier<String> good)
      throws InterruptedException {
    Finding open = link();
    if (!open.passed()) {
      return open;
    }
    long before = heard.sofar(answer);
    sender.accept(question);
    return heard.await(answer, before, ANSWER)
        ? new Finding(true, good.get())
        : new Finding(false, "it has not answered " + asked + " within " + seconds(ANSWER));
  }

  /** Waits for the next solution. */
  public Finding solution(String good) throws InterruptedException {
    Duration patience = pace.longestAge();
    return heard.await(SOLUTION, heard.sofar(SOLUTION), patience)
        ? new Finding(true, good)
        : new Finding(false, "no position frame has come within " + seconds(patience));
  }

  private Finding positions() throws InterruptedException {
    Finding open = link();
    return open.passed() ? solution("the receiver sends position frames") : open;
  }

  private Finding satellites() {
    List<SatelliteInView> seen = satellites.get();
    long used = seen.stream().filter(SatelliteInView::used).count();
    return new Finding(used >= ENOUGH, inWords(seen));
  }

  /** {@code 11 in view, 9 heard, 9 used: G14 41° up, …}. */
  static String inWords(List<SatelliteInView> seen) {
    if (seen.isEmpty()) {
      return "the receiver has told of no satellite";
    }
    long heardOnes = seen.stream().filter(SatelliteInView::isTracked).count();
    long used = seen.stream().filter(SatelliteInView::used).count();
    return seen.size()
        + " in view, "
        + heardOnes
        + " heard, "
        + used
        + " used: "
        + seen.stream().map(SatelliteInView::toString).collect(Collectors.joining("; "));
  }

  private Finding reopenLink() throws InterruptedException {
    return link.reopen("receiver", this::solution);
  }
}
