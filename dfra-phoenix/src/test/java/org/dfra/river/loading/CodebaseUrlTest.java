package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class CodebaseUrlTest {

  private static final String DIGEST = "0123456789abcdef".repeat(4);

  @Test
  void readsEveryUrlOfAnAnnotation() {
    List<CodebaseUrl> urls =
        CodebaseUrl.parse(
            "httpmd://10.0.0.7:8085/a.jar;sha-256="
                + DIGEST.toUpperCase(java.util.Locale.ROOT)
                + "  httpmd://[fe80::1]:80/x/b.jar;SHA-256="
                + DIGEST
                + ",comment");
    assertThat(urls).extracting(CodebaseUrl::digest).containsOnly(DIGEST);
    assertThat(urls)
        .extracting(url -> url.location().toString())
        .containsExactly("http://10.0.0.7:8085/a.jar", "http://[fe80::1]:80/x/b.jar");
  }

  @ParameterizedTest
  @CsvSource({
    "http://10.0.0.7/a.jar, http: is not accepted",
    "https://10.0.0.7/a.jar, https: is not accepted",
    "file:/tmp/a.jar, file: is not accepted",
    "FILE:/tmp/a.jar, file: is not accepted",
    "jar:httpmd://h/a.jar!/, jar: is not accepted",
    "ftp://h/a.jar;sha-256=00, ftp: is not accepted",
    "a.jar, it is not a URL",
    "httpmd://h/a.jar, it is not of the form httpmd://host:port/name.jar;sha-256=digest",
    "httpmd://user@h/a.jar;sha-256=00, it is not of the form",
    "httpmd:///a.jar;sha-256=00, it is not of the form",
    "httpmd://h/a.jar?q;sha-256=00, it is not of the form",
    "httpmd://h/a.jar;md5=00, its digest is md5 with 2 digits",
    "httpmd://h/a.jar;sha-256=00, its digest is sha-256 with 2 digits"
  })
  void refusesEverythingElseByName(String text, String why) {
    assertThatThrownBy(() -> CodebaseUrl.parse(text))
        .isInstanceOf(CodeRefusedException.class)
        .hasMessageStartingWith("codebase " + text + " refused: " + why)
        .hasMessageEndingWith("; serve the jar with a class server");
  }

  @Test
  void refusesAnEmptyOne() {
    assertThatThrownBy(() -> CodebaseUrl.parse(" "))
        .isInstanceOf(CodeRefusedException.class)
        .hasMessageContaining("the codebase has no URL");
  }
}
