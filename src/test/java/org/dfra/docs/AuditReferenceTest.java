package org.dfra.docs;

import static org.assertj.core.api.Assertions.assertThat;

import java.lang.reflect.Method;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Duration;
import java.time.Instant;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.dfra.core.audit.AuditEvent;
import org.dfra.core.audit.AuditKind;
import org.dfra.core.audit.AuditKind.SecurityMode;
import org.dfra.core.audit.AuditSettings;
import org.dfra.core.audit.AuditTrail;
import org.dfra.core.audit.AuditVerifier;
import org.dfra.core.audit.AuditedGuard;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.security.AccessRequest;
import org.dfra.security.Caller;
import org.dfra.security.Caller.Standing;
import org.dfra.security.Decision;
import org.dfra.security.Member;
import org.dfra.security.MemberRole;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The example of {@code docs/reference/audit.md} is what a trail writes, byte by byte. */
class AuditReferenceTest {

  private static final Pattern EXAMPLE = Pattern.compile("(?ms)^```json\\n(.*?)^```$");
  private static final Duration PATIENCE = Duration.ofSeconds(10);
  private static final String STREAM = "atrv1.wheels";
  private static final String FILE = STREAM + ".000001.jsonl";

  private static final Caller ANNA = member(MemberRole.OPERATOR, "anna", "192.0.2.7");
  private static final Caller BEN = member(MemberRole.OBSERVER, "ben", "192.0.2.8");

  @TempDir Path temp;

  private volatile Instant now = Instant.parse("2026-11-28T21:14:00Z");

  private static String example() {
    Matcher found = EXAMPLE.matcher(Documents.of("docs/reference/audit.md").text());
    assertThat(found.find()).as("a block of JSON").isTrue();
    return found.group(1);
  }

  private static Caller member(MemberRole role, String name, String address) {
    return new Caller(Standing.MEMBER, Optional.of(new Member("field", role, name)), address);
  }

  private static AccessRequest call(Caller caller, String object, Class<?> type, String method) {
    Method called =
        Arrays.stream(type.getMethods())
            .filter(each -> each.getName().equals(method) && !each.isBridge())
            .findFirst()
            .orElseThrow();
    return new AccessRequest(caller, "atrv1", object, called);
  }

  private static Decision decide(AccessRequest request) {
    if (request.method().getName().equals("fix")) {
      return Decision.permit("everybody-reads");
    }
    return request.caller().equals(ANNA)
        ? Decision.permit("operators-drive")
        : Decision.deny("observers-read", "an observer may not drive; ask an operator");
  }

  @Test
  void theExampleIsWhatATrailWrites() throws Exception {
    Path folder = temp.resolve("audit");
    AuditSettings settings = AuditSettings.of(folder, STREAM, "robot atrv1 of field");
    // long enough that only this test ends intervals
    AuditSettings slow =
        new AuditSettings(
            folder,
            STREAM,
            settings.owner(),
            8,
            settings.bytesPerFile(),
            Duration.ofHours(1),
            4096,
            500,
            50);
    AccessRequest bens = call(BEN, "wheels", DriveEffector.class, "execute");
    AccessRequest fix = call(ANNA, "gps_front", GPSSensor.class, "fix");
    try (AuditTrail trail = new AuditTrail(slow, () -> now)) {
      AuditedGuard guard =
          new AuditedGuard(
              AuditReferenceTest::decide,
              trail,
              method -> method.getName().equals("fix"),
              decision -> decision.rule().equals("operators-drive") ? List.of("log") : List.of());
      trail.start();
      trail.record(AuditEvent.processStarted(SecurityMode.SECURE, "joined team field"));
      trail.flush(PATIENCE);
      now = now.plusMillis(3_120);
      Decision unused = guard.decide(bens);
      unused = guard.decide(call(ANNA, "wheels", DriveEffector.class, "execute"));
      for (int i = 0; i < 41; i++) {
        unused = guard.decide(bens);
      }
      for (int i = 0; i < 1_200; i++) {
        unused = guard.decide(fix);
      }
      now = Instant.parse("2026-11-28T21:14:10Z");
      trail.flush(PATIENCE);
      now = Instant.parse("2026-11-28T21:20:00Z");
    }
    assertThat(folder.resolve(FILE)).hasContent(example());
  }

  @Test
  void theExampleIsWholeAndAChangeOfItIsFound() throws Exception {
    Path file = temp.resolve(FILE);
    Files.writeString(file, example());
    assertThat(AuditVerifier.verify(temp, List.of()).get(0).broken()).isEmpty();
    Files.writeString(file, example().replace("\"count\":41", "\"count\":1"));
    assertThat(AuditVerifier.verify(temp, List.of()).get(0).broken())
        .hasValueSatisfying(each -> assertThat(each.line()).isEqualTo(5));
  }

  @Test
  void everyKindIsExplained() {
    String text = Documents.of("docs/reference/audit.md").text();
    for (AuditKind each : AuditKind.values()) {
      assertThat(text).contains("\n| `" + each.text() + "` |");
    }
  }
}
