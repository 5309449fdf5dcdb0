package org.dfra.cli.audit;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.core.audit.AuditSettings;
import org.dfra.core.audit.AuditVerifier;
import org.dfra.core.audit.HeadStore;
import org.dfra.core.audit.KeptHead;
import org.dfra.core.audit.VerifiedStream;
import org.dfra.core.audit.VerifiedStream.Break;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code ./dfra audit verify}. */
@Command(
    name = "verify",
    description =
        "Verifies that no line of the audit trail was changed, removed or inserted, and names the"
            + " first that was.",
    footer = {
      "",
      "Each line has the hash of the line before. Lines that were cut off at the end are only",
      "missed with --head, which names a file of signed heads that another member has kept.",
      "If a chain is broken, the command exits with 1."
    })
final class VerifyCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Option(
      names = "--head",
      paramLabel = "FILE",
      description = "Heads of this trail that another member has kept.")
  private @Nullable Path head;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  /** A stream in JSON. */
  private record View(
      String stream,
      int files,
      long lines,
      long first,
      long last,
      boolean isWhole,
      @Nullable String file,
      @Nullable Long line,
      @Nullable String kind,
      @Nullable String sentence,
      List<String> notes) {

    static View of(VerifiedStream stream) {
      @Nullable Break broken = stream.broken().orElse(null);
      return new View(
          stream.stream(),
          stream.files(),
          stream.lines(),
          stream.first(),
          stream.last(),
          broken == null,
          broken == null ? null : broken.file().toString(),
          broken == null ? null : broken.line(),
          broken == null ? null : broken.kind().name(),
          broken == null ? null : broken.sentence(),
          stream.notes());
    }
  }

  @Override
  public Integer call() throws Exception {
    Path folder = AuditSettings.folder(state.folder());
    List<KeptHead> heads = head == null ? List.of() : HeadStore.read(head);
    List<VerifiedStream> streams = AuditVerifier.verify(folder, heads);
    if (streams.isEmpty()) {
      throw new CommandFailure(ExitCode.NOT_FOUND, "there is no audit trail in " + folder);
    }
    List<String> lines = new ArrayList<>();
    streams.forEach(each -> describe(each, lines));
    if (head == null) {
      lines.add("Lines that were cut off at the end would not be missed: there is no --head.");
    }
    answer.lines(streams.stream().map(View::of).toList(), lines);
    return streams.stream().allMatch(each -> each.broken().isEmpty())
        ? ExitCode.SUCCESS
        : ExitCode.FAILED;
  }

  private static void describe(VerifiedStream stream, List<String> lines) {
    lines.add(
        stream
            .broken()
            .map(broken -> stream.stream() + " is BROKEN at " + broken)
            .orElseGet(
                () ->
                    stream.stream()
                        + ": lines "
                        + stream.first()
                        + " to "
                        + stream.last()
                        + " are whole, in "
                        + stream.files()
                        + (stream.files() == 1 ? " file" : " files")));
    stream.notes().forEach(note -> lines.add("  " + note));
  }
}
