package org.dfra.core.audit;

import static org.assertj.core.api.Assertions.assertThat;
import static org.dfra.core.audit.AuditFixture.ANNA;
import static org.dfra.core.audit.AuditFixture.CLOCK;
import static org.dfra.core.audit.AuditFixture.DENIED;
import static org.dfra.core.audit.AuditFixture.DRIVE;
import static org.dfra.core.audit.AuditFixture.PATIENCE;
import static org.dfra.core.audit.AuditFixture.READ;
import static org.dfra.core.audit.AuditFixture.STRANGER;
import static org.dfra.core.audit.AuditFixture.count;
import static org.dfra.core.audit.AuditFixture.different;
import static org.dfra.core.audit.AuditFixture.lines;
import static org.dfra.core.audit.AuditFixture.refusal;
import static org.dfra.core.audit.AuditFixture.request;
import static org.dfra.core.audit.AuditFixture.settings;
import static org.dfra.core.audit.AuditFixture.unbounded;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.dfra.security.AccessRequest;
import org.dfra.security.Behalf;
import org.dfra.security.Caller;
import org.dfra.security.Decision;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Many events: the trail stays small, counts each, and callers never wait. */
class AuditFloodTest {

  private static final int FLOOD = 100_000;

  @TempDir Path temp;

  private Path folder;

  @BeforeEach
  void nameFolder() {
    folder = temp.resolve("audit");
  }

  private long size() throws Exception {
    long size = 0;
    for (TrailFile each : TrailFile.in(folder, "gps")) {
      size += Files.size(each.path());
    }
    return size;
  }

  private void assertWhole() throws Exception {
    assertThat(AuditVerifier.verify(folder, List.of()).get(0).broken()).isEmpty();
  }

  @Test
  void floodOfEqualRefusalsIsTwoRecordsThatSayHowMany() throws Exception {
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK)) {
      trail.start();
      for (int i = 0; i < FLOOD; i++) {
        trail.record(refusal(STRANGER));
      }
      trail.flush(PATIENCE);
    }
    List<AuditLine> lines = lines(folder);
    assertThat(lines).hasSize(3);
    assertThat(count(lines, AuditKind.CALL)).isEqualTo(FLOOD);
    assertThat(size()).isLessThan(2_000);
    assertWhole();
  }

  @Test
  void floodOfDifferentRefusalsLeavesMembersTheirRecords() throws Exception {
    AuditSettings limited = settings(folder, "gps", 8, AuditSettings.LEAST_BYTES, 500, 50);
    try (AuditTrail trail = new AuditTrail(limited, CLOCK)) {
      trail.start();
      for (int i = 0; i < FLOOD; i++) {
        trail.record(refusal(Caller.stranger("198.51.100." + i)));
      }
      for (int i = 0; i < 500; i++) {
        trail.record(different(i));
      }
      trail.flush(PATIENCE);
      trail.record(refusal(Caller.stranger("in the next interval")));
    }
    List<AuditLine> lines = lines(folder);
    assertThat(lines.stream().filter(each -> each.standing().equals("member"))).hasSize(500);
    assertThat(lines.stream().filter(each -> each.standing().equals("stranger"))).hasSize(51);
    assertThat(count(lines, AuditKind.RECORDS_DROPPED)).isEqualTo(FLOOD - 50);
    assertThat(size()).isLessThanOrEqualTo(8 * AuditSettings.LEAST_BYTES);
    assertWhole();
  }

  /** Each refusal says what the forged credential says, so they are all different. */
  @Test
  void forgedCredentialsLeaveOtherEventsTheirRecords() throws Exception {
    AuditSettings settings =
        AuditFixture.settings(folder, "gps", 8, AuditSettings.LEAST_BYTES, 10, 5);
    try (AuditTrail trail = new AuditTrail(settings, CLOCK)) {
      trail.start();
      for (int i = 0; i < 100; i++) {
        Behalf forged = Behalf.unproved("the delegation of operator mallory" + i + " is forged");
        trail.record(refusal(AuditFixture.ANNA.onBehalfOf(forged)));
      }
      for (int i = 0; i < 8; i++) {
        trail.record(AuditFixture.different(i));
      }
    }
    List<AuditLine> lines = lines(folder);
    assertThat(lines.stream().filter(each -> each.reason().contains("number "))).hasSize(8);
    assertThat(lines.stream().filter(each -> each.standing().equals("member"))).hasSize(5 + 8);
  }

  @Test
  void readersOfTooManyAddressesAreSummedTogether() throws Exception {
    int readers = AuditIntake.MOST_READS + 1_000;
    try (AuditTrail trail = new AuditTrail(unbounded(folder), CLOCK)) {
      trail.start();
      for (int i = 0; i < readers; i++) {
        trail.recordRead(request(Caller.stranger("198.51.100." + i), READ));
      }
    }
    List<AuditLine> lines = lines(folder);
    assertThat(count(lines, AuditKind.READS)).isEqualTo(readers);
    assertThat(lines.stream().filter(each -> each.standing().isEmpty() && each.count() == 1_000))
        .hasSize(1);
  }

  @Test
  void noEventIsLostBetweenThreadsAndIntervals() throws Exception {
    int threads = 8;
    int each = 20_000;
    ExecutorService callers = Executors.newFixedThreadPool(threads);
    try (AuditTrail trail = new AuditTrail(unbounded(folder), CLOCK)) {
      trail.start();
      List<Future<?>> ends = new ArrayList<>();
      for (int i = 0; i < threads; i++) {
        AccessRequest own = request(Caller.stranger("198.51.100." + i), READ);
        ends.add(callers.submit(() -> call(trail, own, each)));
      }
      while (ends.stream().anyMatch(end -> !end.isDone())) {
        trail.flush(PATIENCE); // intervals end all the time
      }
      for (Future<?> end : ends) {
        end.get();
      }
    } finally {
      callers.shutdownNow();
    }
    List<AuditLine> lines = lines(folder);
    assertThat(count(lines, AuditKind.READS)).isEqualTo(2L * threads * each);
    assertThat(count(lines, AuditKind.CALL) + count(lines, AuditKind.RECORDS_DROPPED))
        .isEqualTo((long) threads * each);
    assertWhole();
  }

  private static void call(AuditTrail trail, AccessRequest own, int times) {
    AccessRequest shared = request(ANNA, READ);
    AuditEvent command =
        AuditEvent.call(request(ANNA, DRIVE), Decision.permit("operators"), List.of());
    for (int i = 0; i < times; i++) {
      trail.recordRead(own);
      trail.recordRead(shared);
      trail.record(command);
    }
  }

  @Test
  void guardRecordsWhatAnotherDecidesAndChangesNothing() throws Exception {
    Decision permitted = Decision.permit("everybody-reads");
    IllegalStateException bug = new IllegalStateException("a bug");
    try (AuditTrail trail = new AuditTrail(settings(folder, "gps"), CLOCK)) {
      trail.start();
      AuditedGuard guard =
          new AuditedGuard(
              request -> {
                if (request.robot().isEmpty()) {
                  throw bug;
                }
                return request.method().equals(READ) ? permitted : DENIED;
              },
              trail,
              READ::equals,
              decision -> decision.isPermitted() ? List.of() : List.of("notify"));
      assertThat(guard.decide(request(ANNA, READ))).isSameAs(permitted);
      assertThat(guard.decide(request(ANNA, DRIVE))).isSameAs(DENIED);
      assertThat(thrownBy(() -> guard.decide(new AccessRequest(STRANGER, "", "", READ))))
          .isSameAs(bug);
    }
    assertThat(lines(folder))
        .extracting(each -> String.join(" ", each.kind(), each.decision(), each.reason()))
        .containsExactly(
            "call deny only operators may drive",
            "call error the guard failed: java.lang.IllegalStateException: a bug",
            "reads permit ",
            "end  ");
    assertThat(lines(folder).get(0).obligations()).containsExactly("notify");
  }

  private static Exception thrownBy(Callable<?> call) {
    try {
      Object unused = call.call();
    } catch (Exception e) {
      return e;
    }
    throw new AssertionError("nothing was thrown");
  }
}
