package org.dfra.app.stop;

import java.io.IOException;
import java.net.InetAddress;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.dfra.app.team.TeamOptions;
import org.dfra.river.access.OwnAddresses;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.phoenix.stop.StopLocator;
import org.jspecify.annotations.Nullable;

/**
 * Where the phoenixes of known robots run: by configuration (the state folder of this computer, an
 * option, a variable, the hosts of named lookup services) and by discovery (the hosts of the lookup
 * services that were found). Never by an entry, which anybody may register.
 */
final class PhoenixAddresses {

  private static final String VARIABLE = "DFRA_PHOENIX";
  private static final int LARGEST_PORT = 65535;

  private final TeamOptions options;
  private final List<String> named;

  /**
   * @param named those of the command line, {@code host} or {@code host:port} each; null for those
   *     of the environment
   */
  PhoenixAddresses(TeamOptions options, String @Nullable [] named) {
    this.options = options;
    this.named = named == null ? ofEnvironment() : List.of(named);
  }

  /**
   * Where a phoenix may run.
   *
   * @param host address or name
   * @param port its TCP port
   */
  record Address(String host, int port) {
    @Override
    public String toString() {
      return (host.contains(":") ? "[" + host + "]" : host) + ":" + port;
    }
  }

  private static List<String> ofEnvironment() {
    @Nullable String variable = System.getenv(VARIABLE);
    return variable == null ? List.of() : Arrays.asList(variable.split(",", -1));
  }

  /**
   * Those that are configured.
   *
   * @param unasked is given a sentence about each that cannot be asked
   */
  List<Address> configured(Consumer<String> unasked) {
    List<Address> all = new ArrayList<>();
    local().ifPresent(all::add);
    for (String each : named) {
      if (!each.isBlank()) {
        parse("phoenix://" + each.strip())
            .filter(address -> address.port() >= 1 && address.port() <= LARGEST_PORT)
            .ifPresentOrElse(
                all::add,
                () ->
                    unasked.accept(
                        "phoenix "
                            + each.strip()
                            + " cannot be ordered: it is not of the form HOST or HOST:PORT"));
      }
    }
    return List.copyOf(all);
  }

  /** That of this computer, where one was ever started with this state folder. */
  private Optional<Address> local() {
    try {
      if (options.knownRobots().isEmpty() && !Files.exists(options.state().resolve("journal"))) {
        return Optional.empty();
      }
    } catch (IOException | RuntimeException e) { // the search for local effectors remarks it
      if (!Files.exists(options.state().resolve("journal"))) {
        return Optional.empty();
      }
    }
    try {
      PhoenixProcess phoenix = options.phoenix();
      return Optional.of(new Address(phoenix.host(), phoenix.port()));
    } catch (IOException | RuntimeException e) { // its address file is damaged, say
      options.answer().remark("phoenix of this host has no readable address: " + e.getMessage());
      return Optional.empty();
    }
  }

  /** Those of the computers of the lookup services that were named. May wait for their names. */
  List<Address> ofLocators() {
    return options.namedLocators().stream()
        .flatMap(each -> parse(each).stream())
        .flatMap(each -> ofRegistrar(each.host()).stream())
        .toList();
  }

  /**
   * That of the computer on which a lookup service runs, at the usual port. Empty for this
   * computer: its phoenix is the one of the state folder.
   *
   * @param host where the lookup service says that it runs
   */
  Optional<Address> ofRegistrar(String host) {
    return isHere(host)
        ? Optional.empty()
        : Optional.of(new Address(host, StopLocator.DEFAULT_PORT));
  }

  private static boolean isHere(String host) {
    try {
      return OwnAddresses.ofThisComputer().contain(InetAddress.getByName(host));
    } catch (UnknownHostException e) {
      return false;
    }
  }

  private static Optional<Address> parse(String uri) {
    try {
      URI parsed = new URI(uri);
      @Nullable String host = parsed.getHost();
      if (host == null) {
        return Optional.empty();
      }
      String plain = host.startsWith("[") ? host.substring(1, host.length() - 1) : host;
      int port = parsed.getPort();
      return Optional.of(new Address(plain, port < 0 ? StopLocator.DEFAULT_PORT : port));
    } catch (URISyntaxException e) { // reported by whoever named it
      return Optional.empty();
    }
  }
}
