package org.dfra.app.stop;

import static org.assertj.core.api.Assertions.assertThat;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dfra.app.stop.PhoenixAddresses.Address;
import org.dfra.app.team.TeamOptions;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** Which phoenixes a stop orders, and at which addresses. */
class PhoenixAddressesTest {

  /** A command with the options of {@code stop}. */
  @Command(name = "looks")
  static final class Looks {

    @Mixin private TeamOptions options;
  }

  @TempDir Path state;

  private final List<String> unasked = new ArrayList<>();

  private PhoenixAddresses addresses(String locators, String... named) {
    Looks looks = new Looks();
    var unused = new CommandLine(looks).parseArgs("--state=" + state, "--locator=" + locators);
    return new PhoenixAddresses(looks.options, named);
  }

  @Test
  void thoseThatAreNamedHaveTheUsualPortUnlessAnotherIsNamed() {
    PhoenixAddresses addresses =
        addresses("192.0.2.1", "192.0.2.7", " 192.0.2.8:1199 ", "", "[2001:db8::7]:1200");
    assertThat(addresses.configured(unasked::add))
        .extracting(Address::toString)
        .containsExactly("192.0.2.7:1198", "192.0.2.8:1199", "[2001:db8::7]:1200");
    assertThat(unasked).isEmpty();
  }

  @Test
  void oneThatCannotBeReadIsReportedAndTheOthersAreOrdered() {
    assertThat(addresses("192.0.2.1", "no host", "192.0.2.7").configured(unasked::add))
        .containsExactly(new Address("192.0.2.7", 1198));
    assertThat(unasked)
        .containsExactly(
            "phoenix no host cannot be ordered: it is not of the form HOST or HOST:PORT");
  }

  @Test
  void theOneOfThisComputerComesFirstWhereItWasEverStarted() throws Exception {
    assertThat(addresses("192.0.2.1").configured(unasked::add)).isEmpty();
    Files.createDirectory(state.resolve("journal"));
    Files.writeString(state.resolve("phoenix.address"), "127.0.0.9:4711\n");
    assertThat(addresses("192.0.2.1", "192.0.2.7").configured(unasked::add))
        .containsExactly(new Address("127.0.0.9", 4711), new Address("192.0.2.7", 1198));
  }

  @Test
  void theComputersOfLookupServicesHaveOneAndThisComputerHasNoSecondOne() {
    PhoenixAddresses addresses = addresses("192.0.2.9:4161,jini://127.0.0.1:4160");
    assertThat(addresses.ofLocators()).containsExactly(new Address("192.0.2.9", 1198));
    assertThat(addresses.ofRegistrar("192.0.2.10")).contains(new Address("192.0.2.10", 1198));
    assertThat(addresses.ofRegistrar("127.0.0.2")).isEmpty();
  }
}
