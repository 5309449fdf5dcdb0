package org.dfra.cli.stop;

import static org.assertj.core.api.Assertions.assertThat;

import org.dfra.river.bootstrap.HostAddress;
import org.junit.jupiter.api.Test;

/** Who stops, as effectors keep it. */
class StopCommandTest {

  @Test
  void aNameOfThisComputerIsTakenWithoutAskingANameService() {
    assertThat(StopCommand.requester("ops", "no-such-host.invalid"))
        .as("a name service would refuse it")
        .isEqualTo("ops at no-such-host.invalid");
  }

  @Test
  void anAddressOfAnotherComputerIsLeftOut() {
    assertThat(StopCommand.requester("ops", "127.0.0.1")).isEqualTo("ops at 127.0.0.1");
    assertThat(StopCommand.requester("ops", "203.0.113.9")).isEqualTo("ops");
    assertThat(StopCommand.requester("ops", HostAddress.AUTO)).startsWith("ops at ");
  }
}
