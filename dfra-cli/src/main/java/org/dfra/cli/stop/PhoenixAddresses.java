package org.dfra.cli.stop;

import java.io.IOException;
import java.net.InetAddress;
import java.net.URI;
import java.net.URISyntaxException;
import java.net.UnknownHostException;
import java.nio.file.Files;
import java.rmi.RemoteException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.dfra.cli.team.TeamOptions;
import org.dfra.river.access.OwnAddresses;
import org.dfra.river.bootstrap.HostAddress;
import org.dfra.river.bootstrap.PhoenixProcess;
import org.dfra.river.phoenix.stop.StopLocator;
import org.jspecify.annotations.Nullable;

/**
 * The addresses of known robots' phoenixes: by configuration (the state folder of this computer, an
 * option, a variable, the hosts of named lookup services) and by discovery (the hosts of discovered
 * lookup services). Lookup entries are never used, since any client may register them.
 *
 * <p>Only {@link #resolve} uses a name service, which may take long; it runs on the thread of one
 * stop request.
 */
final class PhoenixAddresses {

  private static final String VARIABLE = "DFRA_PHOENIX";
  private static final int LARGEST_PORT = 65535;

  /** Longest host name, RFC 1035. */
  private static final int LONGEST_HOST = 253;

  /** Resolves host names. */
  interface NameService {
    /** The address. May block. */
    InetAddress address(String name) throws UnknownHostException;
  }

  /** The source of a phoenix's address. */
  enum Origin {
    /** The state folder, or the operator's option. */
    NAMED(true) {
      @Override
      boolean isLeftOut(InetAddress address) {
        return false;
      }
    },
    /**
     * The host of a lookup service that the operator named. Loopback addresses are omitted: if
     * several users or tests simulate robots on one computer, that phoenix may belong to another
     * user.
     */
    LOCATOR(true) {
      @Override
      boolean isLeftOut(InetAddress address) {
        return address.isLoopbackAddress();
      }
    },
    /**
     * The claimed host of a discovered lookup service. This computer is omitted: its other
     * phoenixes were not named.
     */
    DISCOVERY(false) {
      @Override
      boolean isLeftOut(InetAddress address) {
        return OwnAddresses.ofThisComputer().contains(address);
      }
    };

    private final boolean isConfigured;

    Origin(boolean isConfigured) {
      this.isConfigured = isConfigured;
    }

    /** Whether the operator has configured it. */
    boolean isConfigured() {
      return isConfigured;
    }

    abstract boolean isLeftOut(InetAddress address);
  }

  private final TeamOptions options;
  private final List<String> named;
  private final NameService names;

  /**
   * @param named addresses of the command line, {@code host} or {@code host:port} each; null for
   *     those of the environment
   */
  PhoenixAddresses(TeamOptions options, String @Nullable [] named, NameService names) {
    this.options = options;
    this.named = named == null ? ofEnvironment() : List.of(named);
    this.names = names;
  }

  /**
   * The address of a possible phoenix.
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
   * The configured addresses.
   *
   * @param unasked receives a sentence about each address that cannot be queried
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

  /** The phoenix of this computer, if one was ever started with this state folder. */
  private Optional<Address> local() {
    try {
      if (options.knownRobots().isEmpty() && !Files.exists(options.state().resolve("journal"))) {
        return Optional.empty();
      }
    } catch (IOException | RuntimeException e) { // the search for local effectors reports it
      if (!Files.exists(options.state().resolve("journal"))) {
        return Optional.empty();
      }
    }
    try {
      PhoenixProcess phoenix = options.phoenix();
      return Optional.of(new Address(phoenix.host(), phoenix.port()));
    } catch (IOException | RuntimeException e) { // for example, its address file is damaged
      options.answer().note("phoenix of this host has no readable address: " + e.getMessage());
      return Optional.empty();
    }
  }

  /** The hosts of the named lookup services, at the default port. */
  List<Address> ofLocators() {
    return options.namedLocators().stream()
        .flatMap(each -> parse(each).stream())
        .flatMap(each -> at(each.host(), Origin.LOCATOR).stream())
        .distinct()
        .toList();
  }

  /**
   * The host of a discovered lookup service, at the default port. Empty for this computer, and if
   * the host name is invalid.
   *
   * @param host that the lookup service claims, an address or a name
   */
  Optional<Address> ofRegistrar(String host) {
    return host.isEmpty() || host.length() > LONGEST_HOST
        ? Optional.empty()
        : at(host, Origin.DISCOVERY);
  }

  /** A name is kept until {@link #resolve}. */
  private static Optional<Address> at(String host, Origin origin) {
    return HostAddress.literal(host).filter(origin::isLeftOut).isPresent()
        ? Optional.empty()
        : Optional.of(new Address(host, StopLocator.DEFAULT_PORT));
  }

  /**
   * Resolves the address of a phoenix. If its computer has a name, this may wait for a name
   * service.
   *
   * @return its address; empty if the name is one of this computer, and it is omitted
   * @throws java.rmi.UnknownHostException if the name has no address
   */
  Optional<Address> resolve(Address address, Origin origin) throws RemoteException {
    if (origin == Origin.NAMED || HostAddress.literal(address.host()).isPresent()) {
      return Optional.of(address);
    }
    try {
      InetAddress its = names.address(address.host());
      return origin.isLeftOut(its)
          ? Optional.empty()
          : Optional.of(new Address(its.getHostAddress(), address.port()));
    } catch (UnknownHostException e) {
      throw new java.rmi.UnknownHostException("no address of " + address.host() + " is known", e);
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
    } catch (URISyntaxException e) { // reported by the source of the name
      return Optional.empty();
    }
  }
}
