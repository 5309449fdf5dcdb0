package org.dfra.example.probe;

import java.time.Duration;
import org.dfra.core.module.Diagnostics;
import org.dfra.core.module.Diagnostics.DiagnosticFinding;
import org.dfra.drivers.link.EventCounter;
import org.dfra.drivers.link.LinkKeeper;

/** What of the probe can be examined (test {@code readings}) and mended ({@code reopen_link}). */
record ProbeDiagnostics(LinkKeeper keeper, EventCounter received, ProbePeriod pace) {

  static final String OPENING = "opening";
  static final String READING = "reading";

  private static final Duration REOPENING = Duration.ofSeconds(10);

  void declareIn(Diagnostics examinations) {
    examinations.addTest("readings", this::readings);
    examinations.addRecovery("reopen_link", this::reopenLink);
  }

  private DiagnosticFinding readings() throws InterruptedException {
    if (!keeper.isOpen()) {
      return new DiagnosticFinding(false, "the link is not open: " + keeper.fault());
    }
    Duration patience = ProbePeriod.patience(pace.seconds());
    return received.await(READING, received.total(READING), patience)
        ? new DiagnosticFinding(true, "the probe tells its temperature")
        : new DiagnosticFinding(
            false, "no temperature has come within " + ProbePeriod.inWords(patience));
  }

  private DiagnosticFinding reopenLink() throws InterruptedException {
    long before = received.total(OPENING);
    keeper.reopen();
    return received.await(OPENING, before, REOPENING)
        ? readings()
        : new DiagnosticFinding(false, "the link could not be opened again: " + keeper.fault());
  }
}
