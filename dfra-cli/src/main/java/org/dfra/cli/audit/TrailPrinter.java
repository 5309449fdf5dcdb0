package org.dfra.cli.audit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import org.dfra.core.audit.TrailReader;
import org.dfra.core.host.CommandName;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;

/** Prints the records that a user asked for. */
final class TrailPrinter {

  private final ShowOptions options;
  private final CommandOutput answer;
  private final RecordFilter filter;
  private final TrailReader reader;
  private long unreadable;
  private String unreadablePlace = "";

  private TrailPrinter(ShowOptions options) {
    this.options = options;
    answer = options.answer();
    filter = options.filter(Instant.now());
    reader = new TrailReader(options.folder());
  }

  static int show(ShowOptions options) throws IOException, InterruptedException {
    TrailPrinter printer = new TrailPrinter(options);
    boolean isFollowed = options.isFollowing() && Files.isDirectory(options.folder());
    if (!isFollowed) {
      printer.printAll();
      return ExitCode.SUCCESS;
    }
    try (FolderWatch watch = FolderWatch.open(options.folder())) { // before the first reading
      printer.follow(watch);
    }
    return ExitCode.SUCCESS;
  }

  private void printAll() throws IOException {
    NewestRecords newest = read();
    long all = newest.all();
    List<RecordView> records = newest.take();
    if (records.isEmpty()) {
      answer.sentence(records, nothing(options.folder()));
    } else {
      RecordColumns columns = RecordColumns.of(records);
      List<String> lines = new ArrayList<>(List.of(columns.heading()));
      records.forEach(each -> lines.add(columns.line(each)));
      answer.lines(records, lines);
    }
    noteLeftOut(all, records.size());
  }

  private static String nothing(Path folder) {
    return Files.isDirectory(folder)
        ? "The audit trail in " + folder + " has no such record."
        : "There is no audit trail in " + folder + ".";
  }

  private void noteLeftOut(long all, int shown) {
    if (shown < all) {
      answer.note("the newest " + shown + " of " + all + " records; --last 0 shows all");
    }
    if (unreadable > 0) {
      answer.note(
          unreadable
              + (unreadable == 1 ? " line" : " lines")
              + " cannot be read, the first at "
              + unreadablePlace
              + "; type: "
              + CommandName.current()
              + " audit verify");
    }
  }

  /** What was written since the last reading. */
  private NewestRecords read() throws IOException {
    NewestRecords newest = new NewestRecords(options.last());
    reader.read(
        read -> {
          if (read.line().isEmpty()) {
            unreadablePlace = unreadable == 0 ? read.place() : unreadablePlace;
            unreadable++;
          }
          read.line()
              .filter(filter::shows)
              .ifPresent(line -> newest.add(RecordView.of(read.stream(), line)));
        });
    return newest;
  }

  private void follow(FolderWatch watch) throws IOException, InterruptedException {
    do {
      NewestRecords newest = read();
      long all = newest.all();
      List<RecordView> records = newest.take();
      records.forEach(each -> answer.line(each, RecordColumns.USUAL.line(each)));
      noteLeftOut(all, records.size());
      unreadable = 0;
    } while (answer.isOutputOpen() && watch.await());
  }
}
