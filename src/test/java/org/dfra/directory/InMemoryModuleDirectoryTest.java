package org.dfra.directory;

import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import java.util.UUID;
import org.dfra.core.directory.InMemoryModuleDirectory;
import org.dfra.module.Module;
import org.dfra.persona.Attributes;
import org.dfra.persona.PersonaAttributes;
import org.junit.jupiter.api.Test;

class InMemoryModuleDirectoryTest extends DirectoryContract {

  @Override
  Fixture fixture() {
    InMemoryModuleDirectory memory = new InMemoryModuleDirectory();
    UUID robot = UUID.randomUUID();
    return new Fixture() {
      @Override
      public ModuleDirectory directory() {
        return memory;
      }

      @Override
      public void announce(ListedGps module, List<Attributes> attributes, Locality locality) {
        memory.put(module.id(), module, attributes, locality);
      }

      @Override
      public void announce(PersonaAttributes persona) {
        memory.put(new UUID(robot.getMostSignificantBits(), persona.robot().hashCode()), persona);
      }

      @Override
      public void withdraw(UUID id) {
        memory.remove(id);
      }

      @Override
      public void loseSight() {
        memory
            .find(ModuleQuery.of(Module.class))
            .forEach(listing -> memory.markStale(listing.id()));
        memory
            .personas()
            .forEach(
                each ->
                    memory.markStale(
                        new UUID(robot.getMostSignificantBits(), each.robot().hashCode())));
      }

      @Override
      public void close() {}
    };
  }

  @Test
  void refusesASecondModuleOfTheSameName() throws Exception {
    list("atrv1", "gps", 1);
    assertThatThrownBy(() -> list("atrv1", "gps", 1))
        .hasMessage("there is a module atrv1/gps already; rename or remove one of the two");
  }
}
