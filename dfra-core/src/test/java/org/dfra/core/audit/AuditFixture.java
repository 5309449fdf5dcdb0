package org.dfra.core.audit;

import java.io.IOException;
import java.lang.reflect.Method;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Decision;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;

/** Callers, calls and trails of the tests. */
final class AuditFixture {

  static final InstantSource CLOCK = InstantSource.fixed(Instant.parse("2026-11-28T21:00:00.250Z"));

  static final String OWNER = "robot atrv1 of field";

  static final Duration PATIENCE = Duration.ofSeconds(10);

  static final Caller ANNA =
      new Caller(
          Standing.MEMBER,
          Optional.of(new Member("field", MemberRole.OPERATOR, "anna")),
          "192.0.2.7");

  static final Caller STRANGER = Caller.stranger("198.51.100.9");

  static final Decision DENIED = Decision.deny("observers-read", "only operators may drive");

  static final Method DRIVE = method("setVelocity", double.class);
  static final Method READ = method("velocity");

  /** What the tests call. */
  interface Drive {
    void setVelocity(double metresPerSecond);

    double velocity();
  }

  private AuditFixture() {}

  private static Method method(String name, Class<?>... parameters) {
    try {
      return Drive.class.getMethod(name, parameters);
    } catch (NoSuchMethodException e) {
      throw new AssertionError(e);
    }
  }

  static AccessRequest request(Caller caller, Method method) {
    return new AccessRequest(caller, "atrv1", "drive", method);
  }

  static AuditEvent refusal(Caller caller) {
    return AuditEvent.call(request(caller, DRIVE), DENIED, List.of());
  }

  /** An event that is equal to no other one. */
  static AuditEvent different(int number) {
    Decision decision = Decision.deny("observers-read", "number " + number);
    return AuditEvent.call(request(ANNA, DRIVE), decision, List.of());
  }

  /** An event whose line is about 3 kB long, so that files are soon full. */
  static AuditEvent large(int number) {
    Decision decision = Decision.deny("observers-read", number + "…".repeat(900));
    return AuditEvent.call(request(ANNA, DRIVE), decision, List.of());
  }

  /** Small files; intervals that end only by {@link AuditTrail#flush}; rates that are not met. */
  static AuditSettings settings(Path folder, String stream) {
    return settings(folder, stream, 8);
  }

  static AuditSettings settings(Path folder, String stream, int files) {
    return settings(folder, stream, files, AuditSettings.LEAST_BYTES, 100_000, 100_000);
  }

  /** The same with files that are never full. */
  static AuditSettings unbounded(Path folder) {
    return settings(folder, "gps", 8, Long.MAX_VALUE, 100_000, 100_000);
  }

  static AuditSettings settings(
      Path folder, String stream, int files, long bytes, int rate, int strangersRate) {
    return new AuditSettings(
        folder, stream, OWNER, files, bytes, Duration.ofHours(1), 4_096, rate, strangersRate);
  }

  /** A trail of several files that is closed; returns the end of its chain, signed. */
  static AuditHead write(AuditSettings settings, int records, TestMember owner) throws Exception {
    AuditHead head;
    try (AuditTrail trail = new AuditTrail(settings, CLOCK)) {
      trail.start();
      for (int i = 0; i < records; i++) {
        trail.record(large(i));
      }
      trail.flush(PATIENCE);
    }
    try (AuditTrail trail = new AuditTrail(settings, CLOCK)) { // also signs the record of the end
      trail.start();
      head = trail.head(owner.key(), PATIENCE);
    }
    return head;
  }

  /** All lines of all streams but the first ones of files. */
  static List<AuditLine> lines(Path folder) throws IOException {
    List<AuditLine> lines = new ArrayList<>();
    new TrailReader(folder).read(read -> lines.add(read.line().orElseThrow()));
    lines.removeIf(each -> each.is(AuditKind.FILE_OPENED));
    return lines;
  }

  /** How many events the lines of a kind stand for. */
  static long count(List<AuditLine> lines, AuditKind kind) {
    return lines.stream().filter(each -> each.is(kind)).mapToLong(AuditLine::count).sum();
  }
}
