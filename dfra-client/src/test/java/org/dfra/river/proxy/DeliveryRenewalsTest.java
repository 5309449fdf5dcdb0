package org.dfra.river.proxy;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** What deliveries prove about the lease; the server's calls are numbered from 7. */
class DeliveryRenewalsTest {

  private final DeliveryRenewals renewals = new DeliveryRenewals();

  @Test
  void aCallThatTheServerNamesLaterProvesARenewalAfterItWasReceived() {
    assertThat(renewals.received(7, 7, 1_000)).as("the first call").isEmpty();
    assertThat(renewals.received(8, 7, 2_000)).hasValue(1_000);
    assertThat(renewals.received(9, 8, 3_000)).hasValue(2_000);
  }

  /** The server did not get the answer to call 8, and did not renew the lease. */
  @Test
  void aCallThatTheServerDoesNotNameProvesNothing() {
    assertThat(renewals.received(7, 7, 1_000)).isEmpty();
    assertThat(renewals.received(8, 7, 2_000)).hasValue(1_000);
    assertThat(renewals.received(9, 7, 3_000)).isEmpty();
    assertThat(renewals.received(10, 9, 4_000)).hasValue(3_000);
  }

  /** The server gave call 8 up; this process was suspended and received it after call 9. */
  @Test
  void aCallThatIsReceivedTooLateProvesNothing() {
    assertThat(renewals.received(7, 7, 1_000)).isEmpty();
    assertThat(renewals.received(9, 7, 4_000)).hasValue(1_000);
    assertThat(renewals.received(8, 7, 9_000)).as("7 is not the last any more").isEmpty();
    assertThat(renewals.received(10, 9, 10_000)).as("nor is 9").isEmpty();
    assertThat(renewals.received(11, 10, 11_000)).hasValue(10_000);
  }

  @Test
  void callsOfAnEarlierSubscriptionProveNothingAboutTheNext() {
    assertThat(renewals.received(-4_711, -4_711, 1_000)).isEmpty();
    assertThat(renewals.received(7, 7, 2_000)).as("its first call").isEmpty();
    assertThat(renewals.received(8, 7, 3_000)).hasValue(2_000);
  }

  @Test
  void aCallThatComesTwiceCountsFromTheFirstTime() {
    assertThat(renewals.received(7, 7, 1_000)).isEmpty();
    assertThat(renewals.received(7, 7, 5_000)).isEmpty();
    assertThat(renewals.received(8, 7, 6_000)).hasValue(1_000);
  }
}
