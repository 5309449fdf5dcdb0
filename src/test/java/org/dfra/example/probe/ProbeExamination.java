package org.dfra.example.probe;

import java.time.Duration;
import org.dfra.core.module.Examinations;
import org.dfra.core.module.Examinations.Finding;
import org.dfra.drivers.link.Heard;
import org.dfra.drivers.link.LinkKeeper;

/** What of the probe can be examined (test {@code readings}) and mended ({@code reopen_link}). */
record ProbeExamination(LinkKeeper keeper, Heard heard, ProbePace pace) {

  static final String OPENING = "opening";
  static final String READING = "reading";

  private static final Duration REOPENING = Duration.ofSeconds(10);

  void declareIn(Examinations examinations) {
    examinations.test("readings", this::readings);
    examinations.recovery("reopen_link", this::reopenLink);
  }

  private Finding readings() throws InterruptedException {
    if (!keeper.isOpen()) {
      return new Finding(false, "the link is not open: " + keeper.trouble());
    }
    Duration patience = ProbePace.patience(pace.seconds());
    return heard.await(READING, heard.sofar(READING), patience)
        ? new Finding(true, "the probe tells its temperature")
        : new Finding(false, "no temperature has come within " + ProbePace.inWords(patience));
  }

  private Finding reopenLink() throws InterruptedException {
    long before = heard.sofar(OPENING);
    keeper.reopen();
    return heard.await(OPENING, before, REOPENING)
        ? readings()
        : new Finding(false, "the link could not be opened again: " + keeper.trouble());
  }
}
