package org.dfra.cli.audit;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Set;
import java.util.concurrent.Callable;
import org.dfra.cli.team.TeamOptions;
import org.dfra.core.audit.AuditSettings;
import org.dfra.core.audit.AuditVerifier;
import org.dfra.core.audit.HeadStore;
import org.dfra.core.audit.KeptHead;
import org.dfra.core.audit.VerifiedStream;
import org.dfra.core.audit.VerifiedStream.Break;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.ExitCode;
import org.dfra.river.security.news.HeadFiles;
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
      "Each line has the hash of the line before. Lines that were cut off at the end, and a trail",
      "that was written again, are only noticed by signed heads that another member has kept: --from",
      "asks a robot for those of this trail, --head reads them from a file. --trail verifies a copy",
      "of another member's trail, with the heads that this computer keeps.",
      "If a chain is broken, the command exits with 1."
    })
final class VerifyCommand implements Callable<Integer> {

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private TeamOptions team;

  @Option(
      names = "--head",
      paramLabel = "FILE",
      description = "Heads of this trail that another member has kept.")
  private @Nullable Path head;

  @Option(
      names = "--from",
      paramLabel = "ROBOT[,...]",
      hideParamSyntax = true,
      split = ",",
      description = "Robots that are asked for the heads of this trail that they keep.")
  private List<String> from = List.of();

  @Option(
      names = "--trail",
      paramLabel = "FOLDER",
      description = "The trail (default: audit in the state folder).")
  private @Nullable Path trail;

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
    Path folder = trail == null ? AuditSettings.folder(team.state()) : trail;
    List<KeptHead> heads = heads(folder);
    List<VerifiedStream> streams = AuditVerifier.verify(folder, heads);
    if (streams.isEmpty()) {
      throw new CommandFailure(ExitCode.NOT_FOUND, "there is no audit trail in " + folder);
    }
    List<String> lines = new ArrayList<>();
    streams.forEach(each -> describe(each, lines));
    if (heads.isEmpty()) {
      lines.add(
          "Lines that were cut off at the end would not be missed: nobody's heads are known; write"
              + " --from ROBOT or --head FILE.");
    }
    team.answer().lines(streams.stream().map(View::of).toList(), lines);
    return streams.stream().allMatch(each -> each.broken().isEmpty())
        ? ExitCode.SUCCESS
        : ExitCode.FAILED;
  }

  /** Those that others keep of this trail's owners. */
  private List<KeptHead> heads(Path folder) throws IOException, InterruptedException {
    Set<String> owners = AuditVerifier.owners(folder);
    List<KeptHead> heads = new ArrayList<>(head == null ? List.of() : HeadStore.read(head));
    Path kept = HeadFiles.kept(team.state());
    if (Files.exists(kept)) {
      HeadStore.read(kept).stream()
          .filter(each -> owners.contains(each.member().toString()))
          .forEach(heads::add);
    }
    if (!from.isEmpty()) {
      heads.addAll(new HeadKeepers(team).ask(from, owners));
    }
    return heads;
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
