package org.dfra.benchmarks.event;

import java.io.IOException;
import java.rmi.MarshalledObject;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.river.server.ModuleActivation;

/** What a benchmark's module is served from, instead of a robot's XML. */
public final class BenchActivation {

  /** The address of all modules of benchmarks: the loopback. */
  public static final String HOST = "127.0.0.1";

  private BenchActivation() {}

  /**
   * The data of a module's server.
   *
   * @param name of the module, whose robot is {@code bench}
   * @param locators of the lookup services that it joins; empty for none
   * @throws IOException if it cannot be marshalled
   */
  public static MarshalledObject<ModuleActivation> of(
      String name, Class<?> server, Class<?> proxy, Class<?> driver, List<String> locators)
      throws IOException {
    ModuleDescription description =
        new ModuleDescription(
            "bench",
            name,
            server.getName(),
            proxy.getName(),
            driver.getName(),
            null,
            false,
            Parameters.of("bench/" + name, Map.of()),
            SourceLocation.CODE);
    return new MarshalledObject<>(
        new ModuleActivation(description, UUID.randomUUID(), HOST, List.of(), locators));
  }
}
