package org.dfra.cli.event;

import java.time.Instant;
import java.time.InstantSource;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.core.module.ModuleImpl;
import org.dfra.directory.Locality;
import org.dfra.directory.ModuleListing;
import org.dfra.event.Reading;
import org.dfra.lifecycle.Readiness;
import org.dfra.module.Module;

/** A module that publishes what the test has it publish. */
final class Talker extends ModuleImpl {

  /** What it publishes. */
  record Word(Instant measured, double loudness) implements Reading {}

  Talker() {
    super(
        new ModuleContext(
            "atrv1",
            "talker",
            Parameters.of("atrv1/talker", Map.of()),
            InstantSource.fixed(Instant.EPOCH)),
        "a talker",
        "DFRA",
        "1");
  }

  void say(double loudness) {
    publish(new Word(Instant.EPOCH, loudness));
  }

  ModuleListing<Module> listing() {
    return new ModuleListing<>(
        UUID.randomUUID(),
        this,
        "atrv1",
        "talker",
        List.of(),
        Locality.SAME_VM,
        false,
        Instant.EPOCH);
  }

  @Override
  protected void onStart() {
    transitionTo(Readiness.READY);
  }

  @Override
  protected void onClose() {}
}
