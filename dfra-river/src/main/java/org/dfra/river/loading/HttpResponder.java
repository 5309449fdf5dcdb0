package org.dfra.river.loading;

import java.io.IOException;
import java.util.Map;

/** Computes the response of an HTTP server to {@code GET} and {@code HEAD}. */
@FunctionalInterface
interface HttpResponder {

  /**
   * @param path of the request, as it was written, without a query
   * @throws IOException if it cannot be answered; the connection is then closed
   */
  HttpReply answer(String path) throws IOException;

  /**
   * @param status such as 200
   * @param headers besides {@code Content-Length}
   * @param body sent after the headers, except for {@code HEAD}
   */
  record HttpReply(int status, Map<String, String> headers, byte[] body) {

    static final HttpReply NOT_FOUND = new HttpReply(404, Map.of(), new byte[0]);
  }
}
