package org.dfra.core.time;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.condition.EnabledOnOs;
import org.junit.jupiter.api.condition.OS;
import org.junit.jupiter.api.io.TempDir;

class BootIdTest {

  @TempDir Path folder;

  @Test
  void readsAgainAfterAFailureAndNoMoreAfterASuccess() throws Exception {
    Path file = Files.createDirectory(folder.resolve("boot_id")); // it is there, but not readable
    BootId boot = new BootId(file);
    assertThatThrownBy(boot::read).isInstanceOf(IOException.class);
    assertThat(boot.isSupported()).isTrue();
    Files.delete(file);
    Files.writeString(file, "1b9d6bcd\n");
    assertThat(boot.read()).contains("1b9d6bcd");
    Files.delete(file);
    assertThat(boot.read()).contains("1b9d6bcd");
    assertThat(boot.isSupported()).isTrue();
  }

  @Test
  void anEmptyFileNamesNoBoot() throws Exception {
    BootId boot = new BootId(Files.writeString(folder.resolve("boot_id"), "\n"));
    assertThatThrownBy(boot::read).isInstanceOf(IOException.class).hasMessageContaining("is empty");
  }

  @Test
  void someOperatingSystemsNameNoBoots() throws Exception {
    BootId boot = new BootId(folder.resolve("nowhere"));
    assertThat(boot.read()).isEmpty();
    assertThat(boot.isSupported()).isFalse();
  }

  @Test
  @EnabledOnOs(OS.LINUX)
  void linuxNamesItsBoots() throws Exception {
    assertThat(BootId.system().read())
        .contains(Files.readString(Path.of("/proc/sys/kernel/random/boot_id")).strip());
  }
}
