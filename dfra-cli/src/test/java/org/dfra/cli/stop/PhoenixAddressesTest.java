package org.dfra.cli.stop;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.junit.jupiter.api.Assumptions.assumeFalse;

import java.net.InetAddress;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.dfra.cli.stop.PhoenixAddresses.Address;
import org.dfra.cli.stop.PhoenixAddresses.Origin;
import org.dfra.cli.team.TeamOptions;
import org.dfra.river.bootstrap.HostAddress;
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
  private final List<String> lookedUp = new ArrayList<>();

  private PhoenixAddresses addresses(String locators, String... named) {
    Looks looks = new Looks();
    var unused = new CommandLine(looks).parseArgs("--state=" + state, "--locator=" + locators);
    return new PhoenixAddresses(looks.options, named, this::address);
  }

  private InetAddress address(String name) throws UnknownHostException {
    lookedUp.add(name);
    return switch (name) {
      case "robot" -> InetAddress.getByName("192.0.2.9");
      case "here" -> InetAddress.getByName("127.0.0.1");
      default -> throw new UnknownHostException(name);
    };
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
  void theComputersOfLookupServicesHaveOneAndTheLoopbackHasNoFurtherOne() {
    PhoenixAddresses addresses =
        addresses("192.0.2.9:4161,192.0.2.9:4162,jini://127.0.0.1:4160,jini://[::1]:4160");
    assertThat(addresses.ofLocators()).containsExactly(new Address("192.0.2.9", 1198));
    assertThat(addresses.ofRegistrar("192.0.2.10")).contains(new Address("192.0.2.10", 1198));
    assertThat(addresses.ofRegistrar("127.0.0.2")).isEmpty();
    assertThat(addresses.ofRegistrar("::1")).isEmpty();
    assertThat(addresses.ofRegistrar("")).isEmpty();
    assertThat(addresses.ofRegistrar("x".repeat(254))).isEmpty();
  }

  @Test
  void furtherOnesOfThisComputerAreOrderedWhereTheyOrTheirLookupServicesAreNamed()
      throws Exception {
    Files.createDirectory(state.resolve("journal"));
    Files.writeString(state.resolve("phoenix.address"), "127.0.0.9:4711\n");
    String own = HostAddress.resolve(HostAddress.AUTO);
    assumeFalse(HostAddress.isLoopback(own), "this computer has no other address");
    PhoenixAddresses addresses = addresses(own + ":4160", "127.0.0.9:4712", own + ":4713");
    assertThat(addresses.configured(unasked::add))
        .containsExactly(
            new Address("127.0.0.9", 4711), new Address("127.0.0.9", 4712), new Address(own, 4713));
    assertThat(addresses.ofLocators()).containsExactly(new Address(own, 1198));
    assertThat(addresses.ofRegistrar(own)).as("nobody named it").isEmpty();
  }

  @Test
  void noNameServiceIsAskedBeforeAPhoenixIsLocated() throws Exception {
    PhoenixAddresses addresses = addresses("robot:4161,here:4160", "robot:1199", "nowhere");
    Address robot = new Address("robot", 1198);
    Address here = new Address("here", 1198);
    assertThat(addresses.configured(unasked::add))
        .containsExactly(new Address("robot", 1199), new Address("nowhere", 1198));
    assertThat(addresses.ofLocators()).containsExactly(robot, here);
    assertThat(addresses.ofRegistrar("robot")).contains(robot);
    assertThat(addresses.resolve(new Address("192.0.2.9", 1198), Origin.DISCOVERY)).isPresent();
    assertThat(lookedUp).isEmpty();

    assertThat(addresses.resolve(robot, Origin.DISCOVERY)).contains(new Address("192.0.2.9", 1198));
    assertThat(addresses.resolve(here, Origin.DISCOVERY)).isEmpty();
    assertThat(addresses.resolve(here, Origin.LOCATOR)).isEmpty();
    assertThat(addresses.resolve(here, Origin.NAMED)).contains(here);
    assertThatThrownBy(() -> addresses.resolve(new Address("nowhere", 1198), Origin.DISCOVERY))
        .isInstanceOf(java.rmi.UnknownHostException.class)
        .hasMessageContaining("no address of nowhere is known");
    assertThat(lookedUp).containsExactly("robot", "here", "here", "nowhere");
  }
}
