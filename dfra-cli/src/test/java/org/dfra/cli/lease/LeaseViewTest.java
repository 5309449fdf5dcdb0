package org.dfra.cli.lease;

import static org.assertj.core.api.Assertions.assertThat;

import java.time.Duration;
import java.time.Instant;
import java.util.Set;
import java.util.UUID;
import org.dfra.lease.LeaseHandle;
import org.dfra.lease.LeaseRole;
import org.dfra.lease.LeaseStatus;
import org.junit.jupiter.api.Test;

class LeaseViewTest {

  private static final LeaseHandle ID =
      new LeaseHandle(UUID.fromString("7f73df46-0000-4000-8000-000000000000"));

  private static final Duration HELD = Duration.ofSeconds(90);

  @Test
  void showsWhoHoldsItAndForHowLong() {
    LeaseView far =
        LeaseView.of(
            "atrv1/gps",
            new LeaseStatus(
                ID, LeaseRole.CLIENT, "192.0.2.7", Instant.EPOCH, HELD, Duration.ofMillis(8600)));
    assertThat(far.shortId()).isEqualTo("7f73df46");
    assertThat(far.hostInWords()).isEqualTo("192.0.2.7");
    assertThat(far.endInWords()).isEqualTo("in 9 s");
    assertThat(far.local()).isFalse();
    assertThat(far.held()).isEqualTo(HELD);
  }

  @Test
  void showsALeaseThatEndsWithTheModule() {
    LeaseView near =
        LeaseView.of(
            "atrv1/gps", new LeaseStatus(ID, LeaseRole.OBSERVER, null, Instant.EPOCH, HELD, null));
    assertThat(near.hostInWords()).isEqualTo("its own JVM");
    assertThat(near.endInWords()).isEqualTo("with the module");
    assertThat(near.local()).isTrue();
  }

  @Test
  void admitsThatTheHostIsNotKnown() {
    LeaseView somewhere =
        LeaseView.of(
            "atrv1/gps",
            new LeaseStatus(
                ID, LeaseRole.CLIENT, null, Instant.EPOCH, HELD, Duration.ofSeconds(1)));
    assertThat(somewhere.hostInWords()).isEqualTo("not known");
  }

  @Test
  void namesTheModuleThatHoldsItWhereOneIsKnown() {
    LeaseStatus lease =
        new LeaseStatus(
            ID, LeaseRole.COMMANDER, "192.0.2.7", Instant.EPOCH, HELD, Duration.ofSeconds(1));
    LeaseHolders holders =
        new LeaseHolders().add("atrv1/search", Set.of(ID, new LeaseHandle(new UUID(0, 1))));
    assertThat(LeaseView.of("atrv1/drive", lease, holders.of(ID)).holderInWords())
        .isEqualTo("atrv1/search");
    holders.add("atrv1/avoid", Set.of(ID)); // in the same process
    assertThat(LeaseView.of("atrv1/drive", lease, holders.of(ID)).holderInWords())
        .isEqualTo("atrv1/avoid or atrv1/search");
    LeaseHandle another = new LeaseHandle(new UUID(0, 2));
    assertThat(LeaseView.of("atrv1/drive", lease, holders.of(another)).holderInWords())
        .isEqualTo("a program at 192.0.2.7");
  }
}
