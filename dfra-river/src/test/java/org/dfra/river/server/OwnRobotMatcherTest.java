package org.dfra.river.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.IOException;
import java.lang.reflect.Proxy;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import java.util.concurrent.atomic.AtomicLong;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.SourceLocation;
import org.dfra.directory.Locality;
import org.dfra.directory.ModuleListing;
import org.dfra.module.Module;
import org.jspecify.annotations.Nullable;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** A robot's own modules are those whose identities it keeps, whatever the names of others. */
class OwnRobotMatcherTest {

  private static final UUID DRIVE = new UUID(1, 1);
  private static final Module MODULE =
      (Module)
          Proxy.newProxyInstance(
              OwnRobotMatcherTest.class.getClassLoader(),
              new Class<?>[] {Module.class},
              (proxy, method, args) -> null);

  @TempDir Path state;

  private final AtomicLong now = new AtomicLong(7);

  @BeforeEach
  void keepADrive() throws IOException {
    keep("atrv1", "drive", DRIVE);
  }

  private void keep(String robot, String module, UUID id) throws IOException {
    new ModuleIdentity(id, Instant.EPOCH).store(folder(robot, module));
  }

  private Path folder(String robot, String module) {
    return state.resolve("modules").resolve(robot).resolve(module);
  }

  private OwnRobotMatcher own() {
    return own(folder("atrv1", "search").toString());
  }

  private OwnRobotMatcher own(@Nullable String folder) {
    ModuleDescription search =
        new ModuleDescription(
            "atrv1",
            "search",
            "a.Server",
            "a.Proxy",
            "a.Driver",
            null,
            false,
            Parameters.of("atrv1/search", Map.of()),
            SourceLocation.CODE);
    return new OwnRobotMatcher(
        new ModuleActivation(
            search, new UUID(2, 2), Instant.EPOCH, "127.0.0.1", List.of(), List.of(), folder),
        now::get);
  }

  private static ModuleListing<Module> listed(String name, UUID id) {
    return new ModuleListing<>(
        id, MODULE, "atrv1", name, List.of(), Locality.REMOTE, false, Instant.EPOCH);
  }

  @Test
  void oneOfTheSameNameWithAnotherIdentityIsAnotherRobots() {
    OwnRobotMatcher own = own();
    assertThat(own.test(listed("drive", DRIVE))).isTrue();
    assertThat(own.test(listed("drive", new UUID(9, 9)))).isFalse();
    assertThat(own.test(listed("drive", DRIVE))).as("again").isTrue();
  }

  @Test
  void oneThatIsAddedLaterIsItsOwnAtOnceAlsoBesideANamesake() throws IOException {
    OwnRobotMatcher own = own();
    UUID laser = new UUID(3, 3);
    assertThat(own.test(listed("laser", new UUID(9, 9)))).isFalse();
    keep("atrv1", "laser", laser);
    assertThat(own.test(listed("laser", laser))).isTrue();
  }

  @Test
  void thatOfAnotherRobotIsReadAgainNoMoreThanOnceASecond() throws IOException {
    UUID laser = new UUID(3, 3);
    OwnRobotMatcher own = own();
    assertThat(own.test(listed("laser", laser))).isFalse();
    keep("atrv1", "laser", laser);
    now.addAndGet(999_000_000);
    assertThat(own.test(listed("laser", laser))).isFalse();
    now.addAndGet(1_000_000);
    assertThat(own.test(listed("laser", laser))).isTrue();
  }

  @Test
  void aNameThatLeadsElsewhereIsNoModules() throws IOException {
    UUID others = new UUID(4, 4);
    keep("atrv2", "drive", others);
    for (String each :
        List.of("../atrv2/drive", folder("atrv2", "drive").toString(), "", ".", "..", "a\0b")) {
      assertThat(own().test(listed(each, others))).as(each).isFalse();
    }
  }

  @Test
  void anIdentityThatCannotBeReadIsNobodys() throws IOException {
    Files.writeString(folder("atrv1", "drive").resolve("identity"), "id=damaged\n");
    assertThat(own().test(listed("drive", DRIVE))).isFalse();
  }

  @Test
  void aModuleThatStoresNothingCannotDistinguishThem() {
    assertThat(own(null).test(listed("drive", new UUID(9, 9)))).isTrue();
  }
}
