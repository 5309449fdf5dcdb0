/**
 * Trusted code across processes: a real lookup service, a server whose kind of module nobody else
 * has, a client that downloads it, and strangers who would like it to.
 */
package org.dfra.loading;
