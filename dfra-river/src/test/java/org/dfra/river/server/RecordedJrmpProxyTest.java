package org.dfra.river.server;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.ObjectInputStream;
import java.lang.reflect.InvocationHandler;
import java.lang.reflect.Proxy;
import org.junit.jupiter.api.Test;

/** A proxy by JRMP as commit 5b8faecf wrote it, before its classes were renamed. */
class RecordedJrmpProxyTest {

  @Test
  void hasTheRenamedHandlerAndSocketFactory() throws Exception {
    try (ObjectInputStream in =
        new ObjectInputStream(
            RecordedJrmpProxyTest.class.getResourceAsStream("recorded-jrmp-proxy.bin"))) {
      InvocationHandler handler = Proxy.getInvocationHandler(in.readObject());
      assertThat(handler).isInstanceOf(JrmpInvocationHandler.class);
      assertThat(((JrmpInvocationHandler) handler).stub())
          .asString()
          .contains(new JrmpSocketFactory("127.0.0.1", 2000).toString());
    }
  }
}
