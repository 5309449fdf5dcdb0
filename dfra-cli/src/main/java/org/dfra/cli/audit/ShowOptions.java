package org.dfra.cli.audit;

import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.cli.team.PhoenixOptions.StateOption;
import org.dfra.core.audit.AuditSettings;
import org.dfra.report.terminal.CommandOutput;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;
import picocli.CommandLine.Spec.Target;

/** Which records are shown, and how. A picocli mix-in. */
final class ShowOptions {

  private static final Pattern SPAN = Pattern.compile("(\\d{1,6})(s|m|h|d)");

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private StateOption state;

  @Option(
      names = "--who",
      paramLabel = "NAME",
      description = "Only callers with this name, such as anna, or at this address.")
  private @Nullable String who;

  @Option(names = "--denied", description = "Only what was refused.")
  private boolean denied;

  @Option(
      names = "--since",
      paramLabel = "TIME",
      description = "Only the last seconds, minutes, hours or days: 30s, 10m, 2h or 1d.")
  private @Nullable String since;

  @Option(
      names = "--robot",
      paramLabel = "ROBOT",
      description = "Only calls to objects of this robot.")
  private @Nullable String robot;

  @Option(
      names = "--last",
      paramLabel = "N",
      description = "Only the newest N of these records; 0 for all (default ${DEFAULT-VALUE}).")
  private int last = 1_000;

  @Option(
      names = "--follow",
      description = "Also show new records as they are written, until Ctrl-C.")
  private boolean follow;

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Spec(Target.MIXEE)
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandSpec spec;

  CommandOutput answer() {
    return answer;
  }

  boolean isFollowing() {
    return follow;
  }

  /** The folder of the trail, which may be missing. */
  Path folder() {
    return AuditSettings.folder(state.folder());
  }

  /** How many of the newest records are shown. */
  int last() {
    if (last < 0) {
      throw new ParameterException(
          spec.commandLine(), "--last=" + last + " is not a number of records from 0");
    }
    return last == 0 ? Integer.MAX_VALUE : last;
  }

  RecordFilter filter(Instant now) {
    return new RecordFilter(
        Optional.ofNullable(who),
        denied,
        Optional.ofNullable(since).map(text -> now.minus(span(text))),
        Optional.ofNullable(robot));
  }

  private Duration span(String text) {
    Matcher span = SPAN.matcher(text);
    if (!span.matches()) {
      throw new ParameterException(
          spec.commandLine(), "--since=" + text + " is not a time such as 30s, 10m, 2h or 1d");
    }
    long number = Long.parseLong(span.group(1));
    return switch (span.group(2)) {
      case "s" -> Duration.ofSeconds(number);
      case "m" -> Duration.ofMinutes(number);
      case "h" -> Duration.ofHours(number);
      default -> Duration.ofDays(number);
    };
  }
}
