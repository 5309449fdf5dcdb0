package org.dfra.experiments.recruit.simulation;

import static org.assertj.core.api.Assertions.assertThat;

import org.junit.jupiter.api.Test;

/** That a hundred agents talk; how fast, a bench tells. */
class MessageRateTest {

  @Test
  void aHundredAgentsExchangeMessages() {
    MessageRate.Result result = MessageRate.measure(100, 5);
    assertThat(result.delivered()).isGreaterThan(10L * 90 * 5);
  }
}
