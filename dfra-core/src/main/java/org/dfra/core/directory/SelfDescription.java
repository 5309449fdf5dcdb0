package org.dfra.core.directory;

import java.time.Instant;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntSupplier;
import org.dfra.core.module.ModuleImpl;
import org.dfra.module.Identification;
import org.dfra.persona.AttributeProvider;
import org.dfra.persona.Attributes;
import org.dfra.persona.ModuleAttributes;

/**
 * All attributes of a module: those of every module, and those of its driver.
 *
 * @param driver the module
 * @param host address or name of the machine it runs on
 * @param created when it was first registered with its robot
 * @param activated when it was last started
 * @param clients how many clients hold a lease on it
 */
public record SelfDescription(
    ModuleImpl driver, String host, Instant created, Instant activated, IntSupplier clients) {

  /** The current attributes. */
  public List<Attributes> attributes() {
    Identification identification = driver.identification();
    List<Attributes> attributes = new ArrayList<>();
    attributes.add(
        new ModuleAttributes(
            identification.robot(),
            identification.name(),
            driver.getClass().getName(),
            host,
            identification.author(),
            identification.version(),
            driver.readiness(),
            created,
            activated,
            clients.getAsInt()));
    if (driver instanceof AttributeProvider described) {
      attributes.addAll(described.attributes());
    }
    return attributes;
  }
}
