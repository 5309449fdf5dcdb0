package org.dfra.river.loading;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;

import java.util.concurrent.CompletableFuture;
import org.junit.jupiter.api.Test;

class AuthenticatedDigestsTest {

  private static final String DIGEST = "a".repeat(64);
  private static final String CODEBASE = "httpmd://h:1/a.jar;sha-256=" + DIGEST;

  @Test
  void countsInItsThreadUntilItIsClosed() {
    try (AuthenticatedDigests.Scope scope = AuthenticatedDigests.open("CN=atrv1")) {
      assertThat(AuthenticatedDigests.authenticator(DIGEST)).as("opened is not vouched").isNull();
      scope.authenticate(CODEBASE);
      assertThat(AuthenticatedDigests.authenticator(DIGEST)).isEqualTo("CN=atrv1");
      assertThat(
              CompletableFuture.supplyAsync(
                      () -> String.valueOf(AuthenticatedDigests.authenticator(DIGEST)))
                  .join())
          .as("in another thread")
          .isEqualTo("null");
    }
    assertThat(AuthenticatedDigests.authenticator(DIGEST)).isNull();
  }

  @Test
  void anInnerCallOfAnotherPeerHidesTheOuterOne() {
    try (AuthenticatedDigests.Scope outer = AuthenticatedDigests.open("CN=atrv1")) {
      outer.authenticate(CODEBASE);
      try (AuthenticatedDigests.Scope inner = AuthenticatedDigests.open("CN=atrv2")) {
        assertThat(inner).isNotNull();
        assertThat(AuthenticatedDigests.authenticator(DIGEST)).isNull();
        assertThatThrownBy(() -> outer.authenticate(CODEBASE))
            .isInstanceOf(IllegalStateException.class)
            .hasMessageContaining("scope of CN=atrv1");
      }
      assertThat(AuthenticatedDigests.authenticator(DIGEST)).isEqualTo("CN=atrv1");
    }
  }

  @Test
  void vouchesForDigestsOnly() {
    try (AuthenticatedDigests.Scope scope = AuthenticatedDigests.open("CN=atrv1")) {
      assertThatThrownBy(() -> scope.authenticate("http://h/a.jar"))
          .isInstanceOf(CodeRefusedException.class);
    }
  }
}
