package org.dfra.river.phoenix;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.io.InputStream;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.rmi.activation.ActivationDesc;
import java.rmi.activation.ActivationGroupID;
import java.rmi.activation.ActivationInstantiator;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.river.loading.RobotCodebase;
import org.dfra.river.phoenix.stop.StoppableGroup;
import org.dfra.river.server.ModuleActivation;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/**
 * A journal that commit 5b8faecf wrote, before classes were renamed: a snapshot with a group, a
 * module and a launch, and records of the process and its instantiator.
 */
class RecordedJournalTest {

  @TempDir Path folder;

  @BeforeEach
  void restore() throws IOException {
    for (String file : List.of("Version_Number", "Snapshot.2", "Logfile.2")) {
      try (InputStream in = RecordedJournalTest.class.getResourceAsStream("recorded/" + file)) {
        Files.copy(in, folder.resolve(file));
      }
    }
  }

  @Test
  void itsModulesComeBackWithTheNewNamesOfTheirParameters() throws Exception {
    try (Journal journal = Journal.open(folder, 100)) {
      ActivationDesc desc = journal.<ActivationDesc>read(r -> r.objects.values().iterator().next());
      ModuleActivation activation = (ModuleActivation) desc.getData().get();
      ModuleDescription module = activation.module();
      assertThat(module.place()).isEqualTo(new SourceLocation("robot.xml", 11));
      assertThat(module.codebase()).containsExactly("/jars/position-dl.jar");
      assertThat(module.parameters().all())
          .isEqualTo(
              Map.of(
                  "fix_window",
                  new Parameters.Value("30", new SourceLocation("robot.xml", 12)),
                  "method",
                  new Parameters.Value("fix_window", new SourceLocation("robot.xml", 13)),
                  "max_age",
                  new Parameters.Value("0.7", new SourceLocation("position.properties", 3))));
      assertThat(activation.host()).isEqualTo("127.0.0.1");
      assertThat(activation.state()).isEqualTo("/state/atrv1/position");
    }
  }

  @Test
  void itsGroupComesBackWithItsProcessAndInstantiator() throws Exception {
    try (Journal journal = Journal.open(folder, 100)) {
      ActivationGroupID id =
          journal.<ActivationGroupID>read(r -> r.groups.keySet().iterator().next());
      Registrations.GroupRecord group = journal.<Registrations.GroupRecord>read(r -> r.group(id));
      assertThat(group.name).isEqualTo("atrv1.navigation");
      assertThat(group.incarnation).isEqualTo(7);
      assertThat(group.process).isEqualTo(new ProcessIdentity(4711, "tick 1 of boot x"));
      ActivationInstantiator instantiator = group.instantiator.get();
      assertThat(instantiator).isInstanceOf(StoppableGroup.class);
      assertThat(Proxy.getInvocationHandler(instantiator)).asString().contains("127.0.0.1:4711");
      assertThat(
              RobotCodebase.servedPort(
                  List.of(group.desc.getCommandEnvironment().getCommandOptions())))
          .isEqualTo(Optional.of(8085));
    }
  }

  @Test
  void itCanBeWrittenOnAndReadAgain() throws Exception {
    ActivationGroupID id;
    try (Journal journal = Journal.open(folder, 1)) {
      id = journal.<ActivationGroupID>read(r -> r.groups.keySet().iterator().next());
      journal.commit(new JournalRecord.Left(id));
    }
    try (Journal journal = Journal.open(folder, 1)) {
      assertThat(journal.<Boolean>read(r -> r.group(id).leaving)).isTrue();
      ActivationDesc desc = journal.<ActivationDesc>read(r -> r.objects.values().iterator().next());
      assertThat(desc.getData().get()).isInstanceOf(ModuleActivation.class);
    }
  }
}
