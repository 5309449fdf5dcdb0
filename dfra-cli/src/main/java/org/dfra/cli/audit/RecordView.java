package org.dfra.cli.audit;

import java.time.Duration;
import java.time.Instant;
import java.time.ZoneOffset;
import java.time.format.DateTimeFormatter;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.dfra.core.audit.AuditKind;
import org.dfra.core.audit.AuditLine;

/** A record as it is printed; the components are the names in JSON. */
record RecordView(
    String stream,
    long number,
    Instant time,
    String kind,
    String standing,
    String member,
    String behalf,
    String address,
    String robot,
    String object,
    String method,
    String decision,
    String rule,
    String reason,
    List<String> obligations,
    long count,
    Optional<Instant> since) {

  /** UTC; of one width, so that lines are aligned. */
  private static final DateTimeFormatter TIME =
      DateTimeFormatter.ofPattern("uuuu-MM-dd'T'HH:mm:ss.SSS'Z'", Locale.ROOT)
          .withZone(ZoneOffset.UTC);

  private static final double MILLIS = 1e3;

  static RecordView of(String stream, AuditLine line) {
    return new RecordView(
        stream,
        line.number(),
        line.time(),
        line.kind(),
        line.standing(),
        line.member(),
        line.behalf(),
        line.address(),
        line.robot(),
        line.object(),
        line.method(),
        line.decision(),
        line.rule(),
        line.reason(),
        line.obligations(),
        line.count(),
        line.since());
  }

  RecordView {
    obligations = List.copyOf(obligations);
  }

  String timeInWords() {
    return TIME.format(time);
  }

  /** The caller, or else the process. */
  String whoInWords() {
    if (standing.isEmpty()) {
      return "process " + stream;
    }
    String who =
        (member.isEmpty() ? "a stranger" : member) + (behalf.isEmpty() ? "" : " for " + behalf);
    String proved = standing.equals("expired") ? ", expired" : "";
    return who + proved + " (" + address + ")";
  }

  /** What happened, and how often. */
  String whatInWords() {
    String target =
        Stream.of(robot, object).filter(each -> !each.isEmpty()).collect(Collectors.joining("/"));
    String what =
        method.isEmpty() ? kindInWords() : target.isEmpty() ? method : target + " " + method;
    if (since.isEmpty()) {
      return what;
    }
    double seconds = Duration.between(since.get(), time).toMillis() / MILLIS;
    String times = kind.equals(AuditKind.CALL.text()) ? "more" : "times";
    return what
        + String.format(Locale.ROOT, ", %d %s in %.1f s", count, times, Math.max(0, seconds));
  }

  private String kindInWords() {
    for (AuditKind each : AuditKind.values()) {
      if (each.text().equals(kind)) {
        return switch (each) {
          case CALL -> "call";
          case READS -> "reads";
          case POLICY_REPLACED -> "policy replaced";
          case REVOCATION_RECEIVED -> "revocation received";
          case PROCESS_STARTED -> "process started";
          case PROCESS_ENDED -> "process ended";
          case LOGIN_FAILED -> "login failed";
          case CODE_REFUSED -> "code refused";
          case RECORDS_DROPPED -> "events without a record";
          case FILE_OPENED -> "file begun";
          case TORN_LINE -> "torn line moved";
        };
      }
    }
    return kind; // of a later version
  }

  /** The reason, and what the decision obliged to. */
  String reasonInWords() {
    if (obligations.isEmpty()) {
      return reason;
    }
    String obliged = "obliges to " + String.join(", ", obligations);
    return reason.isEmpty() ? obliged : reason + "; " + obliged;
  }
}
