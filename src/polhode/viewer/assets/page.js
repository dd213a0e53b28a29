/* three.js: The MIT License

Copyright © 2010-2026 three.js authors

Permission is hereby granted, free of charge, to any person obtaining a copy
of this software and associated documentation files (the "Software"), to deal
in the Software without restriction, including without limitation the rights
to use, copy, modify, merge, publish, distribute, sublicense, and/or sell
copies of the Software, and to permit persons to whom the Software is
furnished to do so, subject to the following conditions:

The above copyright notice and this permission notice shall be included in
all copies or substantial portions of the Software.

THE SOFTWARE IS PROVIDED "AS IS", WITHOUT WARRANTY OF ANY KIND, EXPRESS OR
IMPLIED, INCLUDING BUT NOT LIMITED TO THE WARRANTIES OF MERCHANTABILITY,
FITNESS FOR A PARTICULAR PURPOSE AND NONINFRINGEMENT. IN NO EVENT SHALL THE
AUTHORS OR COPYRIGHT HOLDERS BE LIABLE FOR ANY CLAIM, DAMAGES OR OTHER
LIABILITY, WHETHER IN AN ACTION OF CONTRACT, TORT OR OTHERWISE, ARISING FROM,
OUT OF OR IN CONNECTION WITH THE SOFTWARE OR THE USE OR OTHER DEALINGS IN
THE SOFTWARE.

The rest is part of polhode, under the MIT licence. */
(()=>{var $g=Object.defineProperty;var qi=(i,t)=>{for(var e in t)$g(i,e,{get:t[e],enumerable:!0})};var ha=class{constructor(t,e){this.seen=t,window.addEventListener("hashchange",()=>{window.location.hash.slice(1)!==this.fragment&&e(this.tables)})}get tables(){return Zg(window.location.hash)??{}}get fragment(){return Yg(this.seen())}get whole(){let{protocol:t,href:e}=window.location;if(t==="about:")return null;let n=this.fragment;return e.split("#")[0]+(n?`#${n}`:"")}changed(){clearTimeout(this.waiting),this.waiting=setTimeout(()=>this.write(),300)}write(){clearTimeout(this.waiting);let{whole:t}=this;if(!(t===null||t===window.location.href))try{window.history.replaceState(null,"",t)}catch{}}};function Yg(i){let t=[];for(let[e,n]of Object.entries(i))if(typeof n!="object")t.push(`${e}=${Pd(n)}`);else for(let[s,r]of Object.entries(n))t.push(`${e}.${s}=${Pd(r)}`);return t.join("&")}var Pd=i=>[i].flat().map(t=>typeof t=="number"?String(t):encodeURIComponent(t)).join(",");function Zg(i){let t={};for(let e of i.replace(/^#/,"").split("&").filter(Boolean)){let[n,...s]=e.split("="),r;try{r=decodeURIComponent(s.join("="))}catch{continue}let[o,a]=n.split("."),c=r.includes(",")?r.split(",").map(Number):r!==""&&Number.isFinite(Number(r))?Number(r):r;[c].flat().some(l=>typeof l=="number"&&!Number.isFinite(l))||(a===void 0?t[o]=c:(t[o]??={})[a]=c)}return Object.keys(t).length?t:null}var ff=0,Gh=1,pf=2;var Ro=1,mf=2,_r=3,ss=0,un=1,hi=2,Ns=0,yr=1,Vh=2,Hh=3,Wh=4,gf=5;var Ds=100,xf=101,_f=102,yf=103,vf=104,Mf=200,Sf=201,bf=202,wf=203,qh=204,Xh=205,Af=206,Ef=207,Tf=208,Rf=209,Cf=210,Pf=211,If=212,Lf=213,Nf=214,Va=0,Ha=1,Wa=2,or=3,qa=4,Xa=5,$a=6,Ya=7,vc=0,Df=1,Uf=2,ui=0,$h=1,Yh=2,Zh=3,Jh=4,Kh=5,jh=6,Qh=7;var tu=300,Us=301,vr=302,Mc=303,Sc=304,Za=1e3,ai=1001,Ja=1002,He=1003,Of=1004;var Co=1005;var Oe=1006,bc=1007;var Di=1008;var _n=1009,eu=1010,nu=1011,Mr=1012,wc=1013,jn=1014,Gn=1015,Qn=1016,Ac=1017,Ec=1018,Os=1020,iu=35902,su=35899,ru=1021,ou=1022,ti=1023,Ci=1026,Ui=1027,Tc=1028,Rc=1029,rs=1030,Cc=1031;var Pc=1033,Po=33776,Io=33777,Lo=33778,No=33779,Ic=35840,Lc=35841,Nc=35842,Dc=35843,Uc=36196,Oc=37492,Fc=37496,Bc=37488,zc=37489,Do=37490,kc=37491,Gc=37808,Vc=37809,Hc=37810,Wc=37811,qc=37812,Xc=37813,$c=37814,Yc=37815,Zc=37816,Jc=37817,Kc=37818,jc=37819,Qc=37820,tl=37821,el=36492,nl=36494,il=36495,sl=36283,rl=36284,Uo=36285,ol=36286;var eo=2300,Ka=2301,ka=2302,Nh=2303,Dh=2400,Uh=2401,Oh=2402;var Ff=3200;var al=0,Bf=1,Oi="",wn="srgb",no="srgb-linear",io="linear",oe="srgb";var Ga=7680;var zf=519,kf=512,Gf=513,Vf=514,au=515,Hf=516,Wf=517,cu=518,lu=519,hu=35044;var uu="300 es",Bn=2e3,ar=2001;function Jg(i){for(let t=i.length-1;t>=0;--t)if(i[t]>=65535)return!0;return!1}function Kg(i){return ArrayBuffer.isView(i)&&!(i instanceof DataView)}function so(i){return document.createElementNS("http://www.w3.org/1999/xhtml",i)}function qf(){let i=so("canvas");return i.style.display="block",i}var Id={},cr=null;function ro(...i){let t="THREE."+i.shift();cr?cr("log",t,...i):console.log(t,...i)}function Xf(i){let t=i[0];if(typeof t=="string"&&t.startsWith("TSL:")){let e=i[1];e&&e.isStackTrace?i[0]+=" "+e.getLocation():i[1]='Stack trace not available. Enable "THREE.Node.captureStackTrace" to capture stack traces.'}return i}function It(...i){i=Xf(i);let t="THREE."+i.shift();if(cr)cr("warn",t,...i);else{let e=i[0];e&&e.isStackTrace?console.warn(e.getError(t)):console.warn(t,...i)}}function Ut(...i){i=Xf(i);let t="THREE."+i.shift();if(cr)cr("error",t,...i);else{let e=i[0];e&&e.isStackTrace?console.error(e.getError(t)):console.error(t,...i)}}function Qr(...i){let t=i.join(" ");t in Id||(Id[t]=!0,It(...i))}function $f(i,t,e){return new Promise(function(n,s){function r(){switch(i.clientWaitSync(t,i.SYNC_FLUSH_COMMANDS_BIT,0)){case i.WAIT_FAILED:s();break;case i.TIMEOUT_EXPIRED:setTimeout(r,e);break;default:n()}}setTimeout(r,e)})}var Yf={[Va]:Va,[Wa]:$a,[qa]:qa,[or]:Xa,[Ha]:Ha,[$a]:Wa,[Ya]:Ya,[Xa]:or},ci=class{addEventListener(t,e){this._listeners===void 0&&(this._listeners={});let n=this._listeners;n[t]===void 0&&(n[t]=[]),n[t].indexOf(e)===-1&&n[t].push(e)}hasEventListener(t,e){let n=this._listeners;return n===void 0?!1:n[t]!==void 0&&n[t].indexOf(e)!==-1}removeEventListener(t,e){let n=this._listeners;if(n===void 0)return;let s=n[t];if(s!==void 0){let r=s.indexOf(e);r!==-1&&s.splice(r,1)}}dispatchEvent(t){let e=this._listeners;if(e===void 0)return;let n=e[t.type];if(n!==void 0){t.target=this;let s=n.slice(0);for(let r=0,o=s.length;r<o;r++)s[r].call(this,t);t.target=null}}},en=["00","01","02","03","04","05","06","07","08","09","0a","0b","0c","0d","0e","0f","10","11","12","13","14","15","16","17","18","19","1a","1b","1c","1d","1e","1f","20","21","22","23","24","25","26","27","28","29","2a","2b","2c","2d","2e","2f","30","31","32","33","34","35","36","37","38","39","3a","3b","3c","3d","3e","3f","40","41","42","43","44","45","46","47","48","49","4a","4b","4c","4d","4e","4f","50","51","52","53","54","55","56","57","58","59","5a","5b","5c","5d","5e","5f","60","61","62","63","64","65","66","67","68","69","6a","6b","6c","6d","6e","6f","70","71","72","73","74","75","76","77","78","79","7a","7b","7c","7d","7e","7f","80","81","82","83","84","85","86","87","88","89","8a","8b","8c","8d","8e","8f","90","91","92","93","94","95","96","97","98","99","9a","9b","9c","9d","9e","9f","a0","a1","a2","a3","a4","a5","a6","a7","a8","a9","aa","ab","ac","ad","ae","af","b0","b1","b2","b3","b4","b5","b6","b7","b8","b9","ba","bb","bc","bd","be","bf","c0","c1","c2","c3","c4","c5","c6","c7","c8","c9","ca","cb","cc","cd","ce","cf","d0","d1","d2","d3","d4","d5","d6","d7","d8","d9","da","db","dc","dd","de","df","e0","e1","e2","e3","e4","e5","e6","e7","e8","e9","ea","eb","ec","ed","ee","ef","f0","f1","f2","f3","f4","f5","f6","f7","f8","f9","fa","fb","fc","fd","fe","ff"],Ld=1234567,sr=Math.PI/180,lr=180/Math.PI;function os(){let i=Math.random()*4294967295|0,t=Math.random()*4294967295|0,e=Math.random()*4294967295|0,n=Math.random()*4294967295|0;return(en[i&255]+en[i>>8&255]+en[i>>16&255]+en[i>>24&255]+"-"+en[t&255]+en[t>>8&255]+"-"+en[t>>16&15|64]+en[t>>24&255]+"-"+en[e&63|128]+en[e>>8&255]+"-"+en[e>>16&255]+en[e>>24&255]+en[n&255]+en[n>>8&255]+en[n>>16&255]+en[n>>24&255]).toLowerCase()}function Gt(i,t,e){return Math.max(t,Math.min(e,i))}function du(i,t){return(i%t+t)%t}function jg(i,t,e,n,s){return n+(i-t)*(s-n)/(e-t)}function Qg(i,t,e){return i!==t?(e-i)/(t-i):0}function to(i,t,e){return(1-e)*i+e*t}function t0(i,t,e,n){return to(i,t,1-Math.exp(-e*n))}function e0(i,t=1){return t-Math.abs(du(i,t*2)-t)}function n0(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*(3-2*i))}function i0(i,t,e){return i<=t?0:i>=e?1:(i=(i-t)/(e-t),i*i*i*(i*(i*6-15)+10))}function s0(i,t){return i+Math.floor(Math.random()*(t-i+1))}function r0(i,t){return i+Math.random()*(t-i)}function o0(i){return i*(.5-Math.random())}function a0(i){i!==void 0&&(Ld=i);let t=Ld+=1831565813;return t=Math.imul(t^t>>>15,t|1),t^=t+Math.imul(t^t>>>7,t|61),((t^t>>>14)>>>0)/4294967296}function c0(i){return i*sr}function l0(i){return i*lr}function h0(i){return i>0&&Number.isInteger(i)&&2**Math.round(Math.log2(i))===i}function u0(i){return Math.pow(2,Math.ceil(Math.log(i)/Math.LN2))}function fu(i){return Math.pow(2,Math.floor(Math.log(i)/Math.LN2))}function d0(i,t,e,n,s){let r=Math.cos,o=Math.sin,a=r(e/2),c=o(e/2),l=r((t+n)/2),h=o((t+n)/2),u=r((t-n)/2),d=o((t-n)/2),f=r((n-t)/2),p=o((n-t)/2);switch(s){case"XYX":i.set(a*h,c*u,c*d,a*l);break;case"YZY":i.set(c*d,a*h,c*u,a*l);break;case"ZXZ":i.set(c*u,c*d,a*h,a*l);break;case"XZX":i.set(a*h,c*p,c*f,a*l);break;case"YXY":i.set(c*f,a*h,c*p,a*l);break;case"ZYZ":i.set(c*p,c*f,a*h,a*l);break;default:It("MathUtils: .setQuaternionFromProperEuler() encountered an unknown order: "+s)}}function cl(i){switch(i.constructor){case Uint32Array:return 4294967295;case Uint16Array:return 65535;case Uint8Array:case Uint8ClampedArray:return 255;case Int32Array:return 2147483647;case Int16Array:return 32767;case Int8Array:return 127;default:return}}function pu(i,t){if(t.constructor===Float32Array)return i;let e=cl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.max(i/e,-1)}function mu(i,t){if(t.constructor===Float32Array)return i;let e=cl(t);if(e===void 0)throw new Error("THREE.MathUtils: Invalid component type.");return Math.round(i*e)}var ll={DEG2RAD:sr,RAD2DEG:lr,generateUUID:os,clamp:Gt,euclideanModulo:du,mapLinear:jg,inverseLerp:Qg,lerp:to,damp:t0,pingpong:e0,smoothstep:n0,smootherstep:i0,randInt:s0,randFloat:r0,randFloatSpread:o0,seededRandom:a0,degToRad:c0,radToDeg:l0,isPowerOfTwo:h0,ceilPowerOfTwo:u0,floorPowerOfTwo:fu,setQuaternionFromProperEuler:d0,normalize:mu,denormalize:pu},Wt=class{static{this.prototype.isVector2=!0}constructor(t=0,e=0){this.x=t,this.y=e}get width(){return this.x}set width(t){this.x=t}get height(){return this.y}set height(t){this.y=t}set(t,e){return this.x=t,this.y=e,this}setScalar(t){return this.x=t,this.y=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;default:throw new Error("THREE.Vector2: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;default:throw new Error("THREE.Vector2: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y)}copy(t){return this.x=t.x,this.y=t.y,this}add(t){return this.x+=t.x,this.y+=t.y,this}addScalar(t){return this.x+=t,this.y+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this}subScalar(t){return this.x-=t,this.y-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this}multiply(t){return this.x*=t.x,this.y*=t.y,this}multiplyScalar(t){return this.x*=t,this.y*=t,this}divide(t){return this.x/=t.x,this.y/=t.y,this}divideScalar(t){return this.multiplyScalar(1/t)}applyMatrix3(t){let e=this.x,n=this.y,s=t.elements;return this.x=s[0]*e+s[3]*n+s[6],this.y=s[1]*e+s[4]*n+s[7],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this}clamp(t,e){return this.x=Gt(this.x,t.x,e.x),this.y=Gt(this.y,t.y,e.y),this}clampScalar(t,e){return this.x=Gt(this.x,t,e),this.y=Gt(this.y,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Gt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this}negate(){return this.x=-this.x,this.y=-this.y,this}dot(t){return this.x*t.x+this.y*t.y}cross(t){return this.x*t.y-this.y*t.x}lengthSq(){return this.x*this.x+this.y*this.y}length(){return Math.sqrt(this.x*this.x+this.y*this.y)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)}normalize(){return this.divideScalar(this.length()||1)}angle(){return Math.atan2(-this.y,-this.x)+Math.PI}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Gt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y;return e*e+n*n}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this}equals(t){return t.x===this.x&&t.y===this.y}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this}rotateAround(t,e){let n=Math.cos(e),s=Math.sin(e),r=this.x-t.x,o=this.y-t.y;return this.x=r*n-o*s+t.x,this.y=r*s+o*n+t.y,this}random(){return this.x=Math.random(),this.y=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y}},ae=class{constructor(t=0,e=0,n=0,s=1){this.isQuaternion=!0,this._x=t,this._y=e,this._z=n,this._w=s}static slerpFlat(t,e,n,s,r,o,a){let c=n[s+0],l=n[s+1],h=n[s+2],u=n[s+3],d=r[o+0],f=r[o+1],p=r[o+2],x=r[o+3];if(u!==x||c!==d||l!==f||h!==p){let m=c*d+l*f+h*p+u*x;m<0&&(d=-d,f=-f,p=-p,x=-x,m=-m);let g=1-a;if(m<.9995){let y=Math.acos(m),S=Math.sin(y);g=Math.sin(g*y)/S,a=Math.sin(a*y)/S,c=c*g+d*a,l=l*g+f*a,h=h*g+p*a,u=u*g+x*a}else{c=c*g+d*a,l=l*g+f*a,h=h*g+p*a,u=u*g+x*a;let y=1/Math.sqrt(c*c+l*l+h*h+u*u);c*=y,l*=y,h*=y,u*=y}}t[e]=c,t[e+1]=l,t[e+2]=h,t[e+3]=u}static multiplyQuaternionsFlat(t,e,n,s,r,o){let a=n[s],c=n[s+1],l=n[s+2],h=n[s+3],u=r[o],d=r[o+1],f=r[o+2],p=r[o+3];return t[e]=a*p+h*u+c*f-l*d,t[e+1]=c*p+h*d+l*u-a*f,t[e+2]=l*p+h*f+a*d-c*u,t[e+3]=h*p-a*u-c*d-l*f,t}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get w(){return this._w}set w(t){this._w=t,this._onChangeCallback()}set(t,e,n,s){return this._x=t,this._y=e,this._z=n,this._w=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._w)}copy(t){return this._x=t.x,this._y=t.y,this._z=t.z,this._w=t.w,this._onChangeCallback(),this}setFromEuler(t,e=!0){let n=t._x,s=t._y,r=t._z,o=t._order,a=Math.cos,c=Math.sin,l=a(n/2),h=a(s/2),u=a(r/2),d=c(n/2),f=c(s/2),p=c(r/2);switch(o){case"XYZ":this._x=d*h*u+l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u-d*f*p;break;case"YXZ":this._x=d*h*u+l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u+d*f*p;break;case"ZXY":this._x=d*h*u-l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u-d*f*p;break;case"ZYX":this._x=d*h*u-l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u+d*f*p;break;case"YZX":this._x=d*h*u+l*f*p,this._y=l*f*u+d*h*p,this._z=l*h*p-d*f*u,this._w=l*h*u-d*f*p;break;case"XZY":this._x=d*h*u-l*f*p,this._y=l*f*u-d*h*p,this._z=l*h*p+d*f*u,this._w=l*h*u+d*f*p;break;default:It("Quaternion: .setFromEuler() encountered an unknown order: "+o)}return e===!0&&this._onChangeCallback(),this}setFromAxisAngle(t,e){let n=e/2,s=Math.sin(n);return this._x=t.x*s,this._y=t.y*s,this._z=t.z*s,this._w=Math.cos(n),this._onChangeCallback(),this}setFromRotationMatrix(t){let e=t.elements,n=e[0],s=e[4],r=e[8],o=e[1],a=e[5],c=e[9],l=e[2],h=e[6],u=e[10],d=n+a+u;if(d>0){let f=.5/Math.sqrt(d+1);this._w=.25/f,this._x=(h-c)*f,this._y=(r-l)*f,this._z=(o-s)*f}else if(n>a&&n>u){let f=2*Math.sqrt(1+n-a-u);this._w=(h-c)/f,this._x=.25*f,this._y=(s+o)/f,this._z=(r+l)/f}else if(a>u){let f=2*Math.sqrt(1+a-n-u);this._w=(r-l)/f,this._x=(s+o)/f,this._y=.25*f,this._z=(c+h)/f}else{let f=2*Math.sqrt(1+u-n-a);this._w=(o-s)/f,this._x=(r+l)/f,this._y=(c+h)/f,this._z=.25*f}return this._onChangeCallback(),this}setFromUnitVectors(t,e){let n=t.dot(e)+1;return n<1e-8?(n=0,Math.abs(t.x)>Math.abs(t.z)?(this._x=-t.y,this._y=t.x,this._z=0,this._w=n):(this._x=0,this._y=-t.z,this._z=t.y,this._w=n)):(this._x=t.y*e.z-t.z*e.y,this._y=t.z*e.x-t.x*e.z,this._z=t.x*e.y-t.y*e.x,this._w=n),this.normalize()}angleTo(t){return 2*Math.acos(Math.abs(Gt(this.dot(t),-1,1)))}rotateTowards(t,e){let n=this.angleTo(t);if(n===0)return this;let s=Math.min(1,e/n);return this.slerp(t,s),this}identity(){return this.set(0,0,0,1)}invert(){return this.conjugate()}conjugate(){return this._x*=-1,this._y*=-1,this._z*=-1,this._onChangeCallback(),this}dot(t){return this._x*t._x+this._y*t._y+this._z*t._z+this._w*t._w}lengthSq(){return this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w}length(){return Math.sqrt(this._x*this._x+this._y*this._y+this._z*this._z+this._w*this._w)}normalize(){let t=this.length();return t===0?(this._x=0,this._y=0,this._z=0,this._w=1):(t=1/t,this._x=this._x*t,this._y=this._y*t,this._z=this._z*t,this._w=this._w*t),this._onChangeCallback(),this}multiply(t){return this.multiplyQuaternions(this,t)}premultiply(t){return this.multiplyQuaternions(t,this)}multiplyQuaternions(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=e._x,c=e._y,l=e._z,h=e._w;return this._x=n*h+o*a+s*l-r*c,this._y=s*h+o*c+r*a-n*l,this._z=r*h+o*l+n*c-s*a,this._w=o*h-n*a-s*c-r*l,this._onChangeCallback(),this}slerp(t,e){let n=t._x,s=t._y,r=t._z,o=t._w,a=this.dot(t);a<0&&(n=-n,s=-s,r=-r,o=-o,a=-a);let c=1-e;if(a<.9995){let l=Math.acos(a),h=Math.sin(l);c=Math.sin(c*l)/h,e=Math.sin(e*l)/h,this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this._onChangeCallback()}else this._x=this._x*c+n*e,this._y=this._y*c+s*e,this._z=this._z*c+r*e,this._w=this._w*c+o*e,this.normalize();return this}slerpQuaternions(t,e,n){return this.copy(t).slerp(e,n)}random(){let t=2*Math.PI*Math.random(),e=2*Math.PI*Math.random(),n=Math.random(),s=Math.sqrt(1-n),r=Math.sqrt(n);return this.set(s*Math.sin(t),s*Math.cos(t),r*Math.sin(e),r*Math.cos(e))}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._w===this._w}fromArray(t,e=0){return this._x=t[e],this._y=t[e+1],this._z=t[e+2],this._w=t[e+3],this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._w,t}fromBufferAttribute(t,e){return this._x=t.getX(e),this._y=t.getY(e),this._z=t.getZ(e),this._w=t.getW(e),this._onChangeCallback(),this}toJSON(){return this.toArray()}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._w}},I=class{static{this.prototype.isVector3=!0}constructor(t=0,e=0,n=0){this.x=t,this.y=e,this.z=n}set(t,e,n){return n===void 0&&(n=this.z),this.x=t,this.y=e,this.z=n,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;default:throw new Error("THREE.Vector3: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;default:throw new Error("THREE.Vector3: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this}multiplyVectors(t,e){return this.x=t.x*e.x,this.y=t.y*e.y,this.z=t.z*e.z,this}applyEuler(t){return this.applyQuaternion(Nd.setFromEuler(t))}applyAxisAngle(t,e){return this.applyQuaternion(Nd.setFromAxisAngle(t,e))}applyMatrix3(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[3]*n+r[6]*s,this.y=r[1]*e+r[4]*n+r[7]*s,this.z=r[2]*e+r[5]*n+r[8]*s,this}applyNormalMatrix(t){return this.applyMatrix3(t).normalize()}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=t.elements,o=1/(r[3]*e+r[7]*n+r[11]*s+r[15]);return this.x=(r[0]*e+r[4]*n+r[8]*s+r[12])*o,this.y=(r[1]*e+r[5]*n+r[9]*s+r[13])*o,this.z=(r[2]*e+r[6]*n+r[10]*s+r[14])*o,this}applyQuaternion(t){let e=this.x,n=this.y,s=this.z,r=t.x,o=t.y,a=t.z,c=t.w,l=2*(o*s-a*n),h=2*(a*e-r*s),u=2*(r*n-o*e);return this.x=e+c*l+o*u-a*h,this.y=n+c*h+a*l-r*u,this.z=s+c*u+r*h-o*l,this}project(t){return this.applyMatrix4(t.matrixWorldInverse).applyMatrix4(t.projectionMatrix)}unproject(t){return this.applyMatrix4(t.projectionMatrixInverse).applyMatrix4(t.matrixWorld)}transformDirection(t){let e=this.x,n=this.y,s=this.z,r=t.elements;return this.x=r[0]*e+r[4]*n+r[8]*s,this.y=r[1]*e+r[5]*n+r[9]*s,this.z=r[2]*e+r[6]*n+r[10]*s,this.normalize()}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this}divideScalar(t){return this.multiplyScalar(1/t)}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this}clamp(t,e){return this.x=Gt(this.x,t.x,e.x),this.y=Gt(this.y,t.y,e.y),this.z=Gt(this.z,t.z,e.z),this}clampScalar(t,e){return this.x=Gt(this.x,t,e),this.y=Gt(this.y,t,e),this.z=Gt(this.z,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Gt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this}cross(t){return this.crossVectors(this,t)}crossVectors(t,e){let n=t.x,s=t.y,r=t.z,o=e.x,a=e.y,c=e.z;return this.x=s*c-r*a,this.y=r*o-n*c,this.z=n*a-s*o,this}projectOnVector(t){let e=t.lengthSq();if(e===0)return this.set(0,0,0);let n=t.dot(this)/e;return this.copy(t).multiplyScalar(n)}projectOnPlane(t){return hh.copy(this).projectOnVector(t),this.sub(hh)}reflect(t){return this.sub(hh.copy(t).multiplyScalar(2*this.dot(t)))}angleTo(t){let e=Math.sqrt(this.lengthSq()*t.lengthSq());if(e===0)return Math.PI/2;let n=this.dot(t)/e;return Math.acos(Gt(n,-1,1))}distanceTo(t){return Math.sqrt(this.distanceToSquared(t))}distanceToSquared(t){let e=this.x-t.x,n=this.y-t.y,s=this.z-t.z;return e*e+n*n+s*s}manhattanDistanceTo(t){return Math.abs(this.x-t.x)+Math.abs(this.y-t.y)+Math.abs(this.z-t.z)}setFromSpherical(t){return this.setFromSphericalCoords(t.radius,t.phi,t.theta)}setFromSphericalCoords(t,e,n){let s=Math.sin(e)*t;return this.x=s*Math.sin(n),this.y=Math.cos(e)*t,this.z=s*Math.cos(n),this}setFromCylindrical(t){return this.setFromCylindricalCoords(t.radius,t.theta,t.y)}setFromCylindricalCoords(t,e,n){return this.x=t*Math.sin(e),this.y=n,this.z=t*Math.cos(e),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this}setFromMatrixScale(t){let e=this.setFromMatrixColumn(t,0).length(),n=this.setFromMatrixColumn(t,1).length(),s=this.setFromMatrixColumn(t,2).length();return this.x=e,this.y=n,this.z=s,this}setFromMatrixColumn(t,e){return this.fromArray(t.elements,e*4)}setFromMatrix3Column(t,e){return this.fromArray(t.elements,e*3)}setFromEuler(t){return this.x=t._x,this.y=t._y,this.z=t._z,this}setFromColor(t){return this.x=t.r,this.y=t.g,this.z=t.b,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this}randomDirection(){let t=Math.random()*Math.PI*2,e=Math.random()*2-1,n=Math.sqrt(1-e*e);return this.x=n*Math.cos(t),this.y=e,this.z=n*Math.sin(t),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z}},hh=new I,Nd=new ae,Ot=class{static{this.prototype.isMatrix3=!0}constructor(t,e,n,s,r,o,a,c,l){this.elements=[1,0,0,0,1,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l)}set(t,e,n,s,r,o,a,c,l){let h=this.elements;return h[0]=t,h[1]=s,h[2]=a,h[3]=e,h[4]=r,h[5]=c,h[6]=n,h[7]=o,h[8]=l,this}identity(){return this.set(1,0,0,0,1,0,0,0,1),this}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],this}extractBasis(t,e,n){return t.setFromMatrix3Column(this,0),e.setFromMatrix3Column(this,1),n.setFromMatrix3Column(this,2),this}setFromMatrix4(t){let e=t.elements;return this.set(e[0],e[4],e[8],e[1],e[5],e[9],e[2],e[6],e[10]),this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[3],c=n[6],l=n[1],h=n[4],u=n[7],d=n[2],f=n[5],p=n[8],x=s[0],m=s[3],g=s[6],y=s[1],S=s[4],v=s[7],A=s[2],w=s[5],_=s[8];return r[0]=o*x+a*y+c*A,r[3]=o*m+a*S+c*w,r[6]=o*g+a*v+c*_,r[1]=l*x+h*y+u*A,r[4]=l*m+h*S+u*w,r[7]=l*g+h*v+u*_,r[2]=d*x+f*y+p*A,r[5]=d*m+f*S+p*w,r[8]=d*g+f*v+p*_,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[3]*=t,e[6]*=t,e[1]*=t,e[4]*=t,e[7]*=t,e[2]*=t,e[5]*=t,e[8]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8];return e*o*h-e*a*l-n*r*h+n*a*c+s*r*l-s*o*c}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=h*o-a*l,d=a*c-h*r,f=l*r-o*c,p=e*u+n*d+s*f;if(p===0)return this.set(0,0,0,0,0,0,0,0,0);let x=1/p;return t[0]=u*x,t[1]=(s*l-h*n)*x,t[2]=(a*n-s*o)*x,t[3]=d*x,t[4]=(h*e-s*c)*x,t[5]=(s*r-a*e)*x,t[6]=f*x,t[7]=(n*c-l*e)*x,t[8]=(o*e-n*r)*x,this}transpose(){let t,e=this.elements;return t=e[1],e[1]=e[3],e[3]=t,t=e[2],e[2]=e[6],e[6]=t,t=e[5],e[5]=e[7],e[7]=t,this}getNormalMatrix(t){return this.setFromMatrix4(t).invert().transpose()}transposeIntoArray(t){let e=this.elements;return t[0]=e[0],t[1]=e[3],t[2]=e[6],t[3]=e[1],t[4]=e[4],t[5]=e[7],t[6]=e[2],t[7]=e[5],t[8]=e[8],this}setUvTransform(t,e,n,s,r,o,a){let c=Math.cos(r),l=Math.sin(r);return this.set(n*c,n*l,-n*(c*o+l*a)+o+t,-s*l,s*c,-s*(-l*o+c*a)+a+e,0,0,1),this}scale(t,e){return Qr("Matrix3: .scale() is deprecated. Use .makeScale() instead."),this.premultiply(uh.makeScale(t,e)),this}rotate(t){return Qr("Matrix3: .rotate() is deprecated. Use .makeRotation() instead."),this.premultiply(uh.makeRotation(-t)),this}translate(t,e){return Qr("Matrix3: .translate() is deprecated. Use .makeTranslation() instead."),this.premultiply(uh.makeTranslation(t,e)),this}makeTranslation(t,e){return t.isVector2?this.set(1,0,t.x,0,1,t.y,0,0,1):this.set(1,0,t,0,1,e,0,0,1),this}makeRotation(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,n,e,0,0,0,1),this}makeScale(t,e){return this.set(t,0,0,0,e,0,0,0,1),this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<9;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<9;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t}clone(){return new this.constructor().fromArray(this.elements)}},uh=new Ot,Dd=new Ot().set(.4123908,.3575843,.1804808,.212639,.7151687,.0721923,.0193308,.1191948,.9505322),Ud=new Ot().set(3.2409699,-1.5373832,-.4986108,-.9692436,1.8759675,.0415551,.0556301,-.203977,1.0569715);function f0(){let i={enabled:!0,workingColorSpace:no,spaces:{},convert:function(s,r,o){return this.enabled===!1||r===o||!r||!o||(this.spaces[r].transfer===oe&&(s.r=Ri(s.r),s.g=Ri(s.g),s.b=Ri(s.b)),this.spaces[r].primaries!==this.spaces[o].primaries&&(s.applyMatrix3(this.spaces[r].toXYZ),s.applyMatrix3(this.spaces[o].fromXYZ)),this.spaces[o].transfer===oe&&(s.r=rr(s.r),s.g=rr(s.g),s.b=rr(s.b))),s},workingToColorSpace:function(s,r){return this.convert(s,this.workingColorSpace,r)},colorSpaceToWorking:function(s,r){return this.convert(s,r,this.workingColorSpace)},getPrimaries:function(s){return this.spaces[s].primaries},getTransfer:function(s){return s===Oi?io:this.spaces[s].transfer},getToneMappingMode:function(s){return this.spaces[s].outputColorSpaceConfig.toneMappingMode||"standard"},getLuminanceCoefficients:function(s,r=this.workingColorSpace){return s.fromArray(this.spaces[r].luminanceCoefficients)},define:function(s){Object.assign(this.spaces,s)},_getMatrix:function(s,r,o){return s.copy(this.spaces[o].fromXYZ).multiply(this.spaces[r].toXYZ)},_getDrawingBufferColorSpace:function(s){return this.spaces[s].outputColorSpaceConfig.drawingBufferColorSpace},_getUnpackColorSpace:function(s=this.workingColorSpace){return this.spaces[s].workingColorSpaceConfig.unpackColorSpace}},t=[.64,.33,.3,.6,.15,.06],e=[.2126,.7152,.0722],n=[.3127,.329];return i.define({[no]:{primaries:t,whitePoint:n,transfer:io,toXYZ:Dd,fromXYZ:Ud,luminanceCoefficients:e,workingColorSpaceConfig:{unpackColorSpace:wn},outputColorSpaceConfig:{drawingBufferColorSpace:wn}},[wn]:{primaries:t,whitePoint:n,transfer:oe,toXYZ:Dd,fromXYZ:Ud,luminanceCoefficients:e,outputColorSpaceConfig:{drawingBufferColorSpace:wn}}}),i}var Kt=f0();function Ri(i){return i<.04045?i*.0773993808:Math.pow(i*.9478672986+.0521327014,2.4)}function rr(i){return i<.0031308?i*12.92:1.055*Math.pow(i,.41666)-.055}var Vs,ja=class{static getDataURL(t,e="image/png"){if(/^data:/i.test(t.src)||typeof HTMLCanvasElement>"u")return t.src;let n;if(t instanceof HTMLCanvasElement)n=t;else{Vs===void 0&&(Vs=so("canvas")),Vs.width=t.width,Vs.height=t.height;let s=Vs.getContext("2d");t instanceof ImageData?s.putImageData(t,0,0):s.drawImage(t,0,0,t.width,t.height),n=Vs}return n.toDataURL(e)}static sRGBToLinear(t){if(typeof HTMLImageElement<"u"&&t instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&t instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&t instanceof ImageBitmap){let e=so("canvas");e.width=t.width,e.height=t.height;let n=e.getContext("2d");n.drawImage(t,0,0,t.width,t.height);let s=n.getImageData(0,0,t.width,t.height),r=s.data;for(let o=0;o<r.length;o++)r[o]=Ri(r[o]/255)*255;return n.putImageData(s,0,0),e}else if(t.data){let e=t.data.slice(0);for(let n=0;n<e.length;n++)e instanceof Uint8Array||e instanceof Uint8ClampedArray?e[n]=Math.floor(Ri(e[n]/255)*255):e[n]=Ri(e[n]);return{data:e,width:t.width,height:t.height}}else return It("ImageUtils.sRGBToLinear(): Unsupported image type. No color space conversion applied."),t}},p0=0,hr=class{constructor(t=null){this.isTextureSource=!0,Object.defineProperty(this,"id",{value:p0++}),this.uuid=os(),this.data=t,this.dataReady=!0,this.version=0}getSize(t){let e=this.data;return typeof HTMLVideoElement<"u"&&e instanceof HTMLVideoElement?t.set(e.videoWidth,e.videoHeight,0):typeof VideoFrame<"u"&&e instanceof VideoFrame?t.set(e.displayWidth,e.displayHeight,0):e!==null?t.set(e.width||0,e.height||0,e.depth||0):t.set(0,0,0),t}set needsUpdate(t){t===!0&&this.version++}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.images[this.uuid]!==void 0)return t.images[this.uuid];let n={uuid:this.uuid,url:""},s=this.data;if(s!==null){let r;if(Array.isArray(s)){r=[];for(let o=0,a=s.length;o<a;o++)s[o].isDataTexture?r.push(dh(s[o].image)):r.push(dh(s[o]))}else r=dh(s);n.url=r}return e||(t.images[this.uuid]=n),n}};function dh(i){return typeof HTMLImageElement<"u"&&i instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&i instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&i instanceof ImageBitmap?ja.getDataURL(i):i.data?{data:Array.from(i.data),width:i.width,height:i.height,type:i.data.constructor.name}:(It("Texture: Unable to serialize Texture."),{})}var m0=0,fh=new I,gn=class i extends ci{constructor(t=i.DEFAULT_IMAGE,e=i.DEFAULT_MAPPING,n=ai,s=ai,r=Oe,o=Di,a=ti,c=_n,l=i.DEFAULT_ANISOTROPY,h=Oi){super(),this.isTexture=!0,Object.defineProperty(this,"id",{value:m0++}),this.uuid=os(),this.name="",this.source=new hr(t),this.mipmaps=[],this.mapping=e,this.channel=0,this.wrapS=n,this.wrapT=s,this.magFilter=r,this.minFilter=o,this.anisotropy=l,this.format=a,this.internalFormat=null,this.type=c,this.offset=new Wt(0,0),this.repeat=new Wt(1,1),this.center=new Wt(0,0),this.rotation=0,this.matrixAutoUpdate=!0,this.matrix=new Ot,this.generateMipmaps=!0,this.mipmapsAutoUpdate=!0,this.premultiplyAlpha=!1,this.flipY=!0,this.unpackAlignment=4,this.colorSpace=h,this.userData={},this.updateRanges=[],this.version=0,this.onUpdate=null,this.renderTarget=null,this.isRenderTargetTexture=!1,this.isArrayTexture=!!(t&&t.depth&&t.depth>1),this.pmremVersion=0,this.isPMREMTexture=!1,this.normalized=!1}get width(){return this.source.getSize(fh).x}get height(){return this.source.getSize(fh).y}get depth(){return this.source.getSize(fh).z}get image(){return this.source.data}set image(t){this.source.data=t}updateMatrix(){this.matrix.setUvTransform(this.offset.x,this.offset.y,this.repeat.x,this.repeat.y,this.rotation,this.center.x,this.center.y)}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}clone(){return new this.constructor().copy(this)}copy(t){return this.name=t.name,this.source=t.source,this.mipmaps=t.mipmaps.slice(0),this.mapping=t.mapping,this.channel=t.channel,this.wrapS=t.wrapS,this.wrapT=t.wrapT,this.magFilter=t.magFilter,this.minFilter=t.minFilter,this.anisotropy=t.anisotropy,this.format=t.format,this.internalFormat=t.internalFormat,this.type=t.type,this.normalized=t.normalized,this.offset.copy(t.offset),this.repeat.copy(t.repeat),this.center.copy(t.center),this.rotation=t.rotation,this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrix.copy(t.matrix),this.generateMipmaps=t.generateMipmaps,this.mipmapsAutoUpdate=t.mipmapsAutoUpdate,this.premultiplyAlpha=t.premultiplyAlpha,this.flipY=t.flipY,this.unpackAlignment=t.unpackAlignment,this.colorSpace=t.colorSpace,this.renderTarget=t.renderTarget,this.isRenderTargetTexture=t.isRenderTargetTexture,this.isPMREMTexture=t.isPMREMTexture,this.isArrayTexture=t.isArrayTexture,this.userData=JSON.parse(JSON.stringify(t.userData)),this.needsUpdate=!0,this}setValues(t){for(let e in t){let n=t[e];if(n===void 0){It(`Texture.setValues(): parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){It(`Texture.setValues(): property '${e}' does not exist.`);continue}s&&n&&s.isVector2&&n.isVector2||s&&n&&s.isVector3&&n.isVector3||s&&n&&s.isMatrix3&&n.isMatrix3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";if(!e&&t.textures[this.uuid]!==void 0)return t.textures[this.uuid];let n={metadata:{version:4.7,type:"Texture",generator:"Texture.toJSON"},uuid:this.uuid,name:this.name,image:this.source.toJSON(t).uuid,mapping:this.mapping,channel:this.channel,repeat:[this.repeat.x,this.repeat.y],offset:[this.offset.x,this.offset.y],center:[this.center.x,this.center.y],rotation:this.rotation,wrap:[this.wrapS,this.wrapT],format:this.format,internalFormat:this.internalFormat,type:this.type,normalized:this.normalized,colorSpace:this.colorSpace,minFilter:this.minFilter,magFilter:this.magFilter,anisotropy:this.anisotropy,flipY:this.flipY,generateMipmaps:this.generateMipmaps,mipmapsAutoUpdate:this.mipmapsAutoUpdate,premultiplyAlpha:this.premultiplyAlpha,unpackAlignment:this.unpackAlignment};return Object.keys(this.userData).length>0&&(n.userData=this.userData),e||(t.textures[this.uuid]=n),n}dispose(){this.dispatchEvent({type:"dispose"})}transformUv(t){if(this.mapping!==tu)return t;if(t.applyMatrix3(this.matrix),t.x<0||t.x>1)switch(this.wrapS){case Za:t.x=t.x-Math.floor(t.x);break;case ai:t.x=t.x<0?0:1;break;case Ja:Math.abs(Math.floor(t.x)%2)===1?t.x=Math.ceil(t.x)-t.x:t.x=t.x-Math.floor(t.x);break}if(t.y<0||t.y>1)switch(this.wrapT){case Za:t.y=t.y-Math.floor(t.y);break;case ai:t.y=t.y<0?0:1;break;case Ja:Math.abs(Math.floor(t.y)%2)===1?t.y=Math.ceil(t.y)-t.y:t.y=t.y-Math.floor(t.y);break}return this.flipY&&(t.y=1-t.y),t}set needsUpdate(t){t===!0&&(this.version++,this.source.needsUpdate=!0)}set needsPMREMUpdate(t){t===!0&&this.pmremVersion++}};gn.DEFAULT_IMAGE=null;gn.DEFAULT_MAPPING=tu;gn.DEFAULT_ANISOTROPY=1;var ce=class{static{this.prototype.isVector4=!0}constructor(t=0,e=0,n=0,s=1){this.x=t,this.y=e,this.z=n,this.w=s}get width(){return this.z}set width(t){this.z=t}get height(){return this.w}set height(t){this.w=t}set(t,e,n,s){return this.x=t,this.y=e,this.z=n,this.w=s,this}setScalar(t){return this.x=t,this.y=t,this.z=t,this.w=t,this}setX(t){return this.x=t,this}setY(t){return this.y=t,this}setZ(t){return this.z=t,this}setW(t){return this.w=t,this}setComponent(t,e){switch(t){case 0:this.x=e;break;case 1:this.y=e;break;case 2:this.z=e;break;case 3:this.w=e;break;default:throw new Error("THREE.Vector4: index is out of range: "+t)}return this}getComponent(t){switch(t){case 0:return this.x;case 1:return this.y;case 2:return this.z;case 3:return this.w;default:throw new Error("THREE.Vector4: index is out of range: "+t)}}clone(){return new this.constructor(this.x,this.y,this.z,this.w)}copy(t){return this.x=t.x,this.y=t.y,this.z=t.z,this.w=t.w!==void 0?t.w:1,this}add(t){return this.x+=t.x,this.y+=t.y,this.z+=t.z,this.w+=t.w,this}addScalar(t){return this.x+=t,this.y+=t,this.z+=t,this.w+=t,this}addVectors(t,e){return this.x=t.x+e.x,this.y=t.y+e.y,this.z=t.z+e.z,this.w=t.w+e.w,this}addScaledVector(t,e){return this.x+=t.x*e,this.y+=t.y*e,this.z+=t.z*e,this.w+=t.w*e,this}sub(t){return this.x-=t.x,this.y-=t.y,this.z-=t.z,this.w-=t.w,this}subScalar(t){return this.x-=t,this.y-=t,this.z-=t,this.w-=t,this}subVectors(t,e){return this.x=t.x-e.x,this.y=t.y-e.y,this.z=t.z-e.z,this.w=t.w-e.w,this}multiply(t){return this.x*=t.x,this.y*=t.y,this.z*=t.z,this.w*=t.w,this}multiplyScalar(t){return this.x*=t,this.y*=t,this.z*=t,this.w*=t,this}applyMatrix4(t){let e=this.x,n=this.y,s=this.z,r=this.w,o=t.elements;return this.x=o[0]*e+o[4]*n+o[8]*s+o[12]*r,this.y=o[1]*e+o[5]*n+o[9]*s+o[13]*r,this.z=o[2]*e+o[6]*n+o[10]*s+o[14]*r,this.w=o[3]*e+o[7]*n+o[11]*s+o[15]*r,this}divide(t){return this.x/=t.x,this.y/=t.y,this.z/=t.z,this.w/=t.w,this}divideScalar(t){return this.multiplyScalar(1/t)}setAxisAngleFromQuaternion(t){this.w=2*Math.acos(t.w);let e=Math.sqrt(1-t.w*t.w);return e<1e-4?(this.x=1,this.y=0,this.z=0):(this.x=t.x/e,this.y=t.y/e,this.z=t.z/e),this}setAxisAngleFromRotationMatrix(t){let e,n,s,r,c=t.elements,l=c[0],h=c[4],u=c[8],d=c[1],f=c[5],p=c[9],x=c[2],m=c[6],g=c[10];if(Math.abs(h-d)<.01&&Math.abs(u-x)<.01&&Math.abs(p-m)<.01){if(Math.abs(h+d)<.1&&Math.abs(u+x)<.1&&Math.abs(p+m)<.1&&Math.abs(l+f+g-3)<.1)return this.set(1,0,0,0),this;e=Math.PI;let S=(l+1)/2,v=(f+1)/2,A=(g+1)/2,w=(h+d)/4,_=(u+x)/4,M=(p+m)/4;return S>v&&S>A?S<.01?(n=0,s=.707106781,r=.707106781):(n=Math.sqrt(S),s=w/n,r=_/n):v>A?v<.01?(n=.707106781,s=0,r=.707106781):(s=Math.sqrt(v),n=w/s,r=M/s):A<.01?(n=.707106781,s=.707106781,r=0):(r=Math.sqrt(A),n=_/r,s=M/r),this.set(n,s,r,e),this}let y=Math.sqrt((m-p)*(m-p)+(u-x)*(u-x)+(d-h)*(d-h));return Math.abs(y)<.001&&(y=1),this.x=(m-p)/y,this.y=(u-x)/y,this.z=(d-h)/y,this.w=Math.acos((l+f+g-1)/2),this}setFromMatrixPosition(t){let e=t.elements;return this.x=e[12],this.y=e[13],this.z=e[14],this.w=e[15],this}min(t){return this.x=Math.min(this.x,t.x),this.y=Math.min(this.y,t.y),this.z=Math.min(this.z,t.z),this.w=Math.min(this.w,t.w),this}max(t){return this.x=Math.max(this.x,t.x),this.y=Math.max(this.y,t.y),this.z=Math.max(this.z,t.z),this.w=Math.max(this.w,t.w),this}clamp(t,e){return this.x=Gt(this.x,t.x,e.x),this.y=Gt(this.y,t.y,e.y),this.z=Gt(this.z,t.z,e.z),this.w=Gt(this.w,t.w,e.w),this}clampScalar(t,e){return this.x=Gt(this.x,t,e),this.y=Gt(this.y,t,e),this.z=Gt(this.z,t,e),this.w=Gt(this.w,t,e),this}clampLength(t,e){let n=this.length();return this.divideScalar(n||1).multiplyScalar(Gt(n,t,e))}floor(){return this.x=Math.floor(this.x),this.y=Math.floor(this.y),this.z=Math.floor(this.z),this.w=Math.floor(this.w),this}ceil(){return this.x=Math.ceil(this.x),this.y=Math.ceil(this.y),this.z=Math.ceil(this.z),this.w=Math.ceil(this.w),this}round(){return this.x=Math.round(this.x),this.y=Math.round(this.y),this.z=Math.round(this.z),this.w=Math.round(this.w),this}roundToZero(){return this.x=Math.trunc(this.x),this.y=Math.trunc(this.y),this.z=Math.trunc(this.z),this.w=Math.trunc(this.w),this}negate(){return this.x=-this.x,this.y=-this.y,this.z=-this.z,this.w=-this.w,this}dot(t){return this.x*t.x+this.y*t.y+this.z*t.z+this.w*t.w}lengthSq(){return this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w}length(){return Math.sqrt(this.x*this.x+this.y*this.y+this.z*this.z+this.w*this.w)}manhattanLength(){return Math.abs(this.x)+Math.abs(this.y)+Math.abs(this.z)+Math.abs(this.w)}normalize(){return this.divideScalar(this.length()||1)}setLength(t){return this.normalize().multiplyScalar(t)}lerp(t,e){return this.x+=(t.x-this.x)*e,this.y+=(t.y-this.y)*e,this.z+=(t.z-this.z)*e,this.w+=(t.w-this.w)*e,this}lerpVectors(t,e,n){return this.x=t.x+(e.x-t.x)*n,this.y=t.y+(e.y-t.y)*n,this.z=t.z+(e.z-t.z)*n,this.w=t.w+(e.w-t.w)*n,this}equals(t){return t.x===this.x&&t.y===this.y&&t.z===this.z&&t.w===this.w}fromArray(t,e=0){return this.x=t[e],this.y=t[e+1],this.z=t[e+2],this.w=t[e+3],this}toArray(t=[],e=0){return t[e]=this.x,t[e+1]=this.y,t[e+2]=this.z,t[e+3]=this.w,t}fromBufferAttribute(t,e){return this.x=t.getX(e),this.y=t.getY(e),this.z=t.getZ(e),this.w=t.getW(e),this}random(){return this.x=Math.random(),this.y=Math.random(),this.z=Math.random(),this.w=Math.random(),this}*[Symbol.iterator](){yield this.x,yield this.y,yield this.z,yield this.w}},Qa=class extends ci{constructor(t=1,e=1,n={}){super(),n=Object.assign({generateMipmaps:!1,internalFormat:null,minFilter:Oe,depthBuffer:!0,stencilBuffer:!1,resolveColorBuffer:!0,resolveDepthBuffer:!0,resolveStencilBuffer:!0,storeMultisampledColorBuffer:!0,storeMultisampledDepthBuffer:!0,storeMultisampledStencilBuffer:!0,depthTexture:null,samples:0,count:1,depth:1,multiview:!1,useArrayDepthTexture:!1},n),this.isRenderTarget=!0,this.width=t,this.height=e,this.depth=n.depth,this.scissor=new ce(0,0,t,e),this.scissorTest=!1,this.viewport=new ce(0,0,t,e),this.textures=[];let s=n.count;for(let r=0;r<s;r++)this.textures[r]=new gn({width:t,height:e,depth:n.depth}),this.textures[r].isRenderTargetTexture=!0,this.textures[r].renderTarget=this;this._setTextureOptions(n),this.depthBuffer=n.depthBuffer,this.stencilBuffer=n.stencilBuffer,this.resolveColorBuffer=n.resolveColorBuffer,this.resolveDepthBuffer=n.resolveDepthBuffer,this.resolveStencilBuffer=n.resolveStencilBuffer,this.storeMultisampledColorBuffer=n.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=n.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=n.storeMultisampledStencilBuffer,this._depthTexture=null,this.depthTexture=n.depthTexture,this.samples=n.samples,this.multiview=n.multiview,this.useArrayDepthTexture=n.useArrayDepthTexture}_setTextureOptions(t={}){let e={minFilter:Oe,generateMipmaps:!1,flipY:!1,internalFormat:null};t.mapping!==void 0&&(e.mapping=t.mapping),t.wrapS!==void 0&&(e.wrapS=t.wrapS),t.wrapT!==void 0&&(e.wrapT=t.wrapT),t.wrapR!==void 0&&(e.wrapR=t.wrapR),t.magFilter!==void 0&&(e.magFilter=t.magFilter),t.minFilter!==void 0&&(e.minFilter=t.minFilter),t.format!==void 0&&(e.format=t.format),t.type!==void 0&&(e.type=t.type),t.anisotropy!==void 0&&(e.anisotropy=t.anisotropy),t.colorSpace!==void 0&&(e.colorSpace=t.colorSpace),t.flipY!==void 0&&(e.flipY=t.flipY),t.generateMipmaps!==void 0&&(e.generateMipmaps=t.generateMipmaps),t.mipmapsAutoUpdate!==void 0&&(e.mipmapsAutoUpdate=t.mipmapsAutoUpdate),t.internalFormat!==void 0&&(e.internalFormat=t.internalFormat);for(let n=0;n<this.textures.length;n++)this.textures[n].setValues(e)}get texture(){return this.textures[0]}set texture(t){this.textures[0]=t}set depthTexture(t){this._depthTexture!==null&&this._depthTexture.renderTarget===this&&(this._depthTexture.renderTarget=null),t!==null&&t.renderTarget===null&&(t.renderTarget=this),this._depthTexture=t}get depthTexture(){return this._depthTexture}setSize(t,e,n=1){if(this.width!==t||this.height!==e||this.depth!==n){this.width=t,this.height=e,this.depth=n;for(let s=0,r=this.textures.length;s<r;s++)this.textures[s].image.width=t,this.textures[s].image.height=e,this.textures[s].image.depth=n,this.textures[s].isData3DTexture!==!0&&(this.textures[s].isArrayTexture=this.textures[s].image.depth>1);this.dispose()}this.viewport.set(0,0,t,e),this.scissor.set(0,0,t,e)}clone(){return new this.constructor().copy(this)}copy(t){this.width=t.width,this.height=t.height,this.depth=t.depth,this.scissor.copy(t.scissor),this.scissorTest=t.scissorTest,this.viewport.copy(t.viewport),this.textures.length=0;for(let e=0,n=t.textures.length;e<n;e++){this.textures[e]=t.textures[e].clone(),this.textures[e].isRenderTargetTexture=!0,this.textures[e].renderTarget=this;let s=Object.assign({},t.textures[e].image);this.textures[e].source=new hr(s)}if(this.depthBuffer=t.depthBuffer,this.stencilBuffer=t.stencilBuffer,this.resolveColorBuffer=t.resolveColorBuffer,this.resolveDepthBuffer=t.resolveDepthBuffer,this.resolveStencilBuffer=t.resolveStencilBuffer,this.storeMultisampledColorBuffer=t.storeMultisampledColorBuffer,this.storeMultisampledDepthBuffer=t.storeMultisampledDepthBuffer,this.storeMultisampledStencilBuffer=t.storeMultisampledStencilBuffer,t.depthTexture!==null)if(t.depthTexture.renderTarget===t){let e=t.depthTexture.clone();e.renderTarget=null,this.depthTexture=e}else this.depthTexture=t.depthTexture;else this.depthTexture=null;return this.samples=t.samples,this.multiview=t.multiview,this.useArrayDepthTexture=t.useArrayDepthTexture,this}dispose(){this.dispatchEvent({type:"dispose"})}},An=class extends Qa{constructor(t=1,e=1,n={}){super(t,e,n),this.isWebGLRenderTarget=!0}},oo=class extends gn{constructor(t=null,e=1,n=1,s=1){super(null),this.isDataArrayTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=He,this.minFilter=He,this.wrapR=ai,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1,this.layerUpdates=new Set}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}addLayerUpdate(t){this.layerUpdates.add(t)}clearLayerUpdates(){this.layerUpdates.clear()}};var tc=class extends gn{constructor(t=null,e=1,n=1,s=1){super(null),this.isData3DTexture=!0,this.image={data:t,width:e,height:n,depth:s},this.magFilter=He,this.minFilter=He,this.wrapR=ai,this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}copy(t){return super.copy(t),this.wrapR=t.wrapR,this}};var te=class i{static{this.prototype.isMatrix4=!0}constructor(t,e,n,s,r,o,a,c,l,h,u,d,f,p,x,m){this.elements=[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1],t!==void 0&&this.set(t,e,n,s,r,o,a,c,l,h,u,d,f,p,x,m)}set(t,e,n,s,r,o,a,c,l,h,u,d,f,p,x,m){let g=this.elements;return g[0]=t,g[4]=e,g[8]=n,g[12]=s,g[1]=r,g[5]=o,g[9]=a,g[13]=c,g[2]=l,g[6]=h,g[10]=u,g[14]=d,g[3]=f,g[7]=p,g[11]=x,g[15]=m,this}identity(){return this.set(1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1),this}clone(){return new i().fromArray(this.elements)}copy(t){let e=this.elements,n=t.elements;return e[0]=n[0],e[1]=n[1],e[2]=n[2],e[3]=n[3],e[4]=n[4],e[5]=n[5],e[6]=n[6],e[7]=n[7],e[8]=n[8],e[9]=n[9],e[10]=n[10],e[11]=n[11],e[12]=n[12],e[13]=n[13],e[14]=n[14],e[15]=n[15],this}copyPosition(t){let e=this.elements,n=t.elements;return e[12]=n[12],e[13]=n[13],e[14]=n[14],this}setFromMatrix3(t){let e=t.elements;return this.set(e[0],e[3],e[6],0,e[1],e[4],e[7],0,e[2],e[5],e[8],0,0,0,0,1),this}extractBasis(t,e,n){return this.determinantAffine()===0?(t.set(1,0,0),e.set(0,1,0),n.set(0,0,1),this):(t.setFromMatrixColumn(this,0),e.setFromMatrixColumn(this,1),n.setFromMatrixColumn(this,2),this)}makeBasis(t,e,n){return this.set(t.x,e.x,n.x,0,t.y,e.y,n.y,0,t.z,e.z,n.z,0,0,0,0,1),this}extractRotation(t){if(t.determinantAffine()===0)return this.identity();let e=this.elements,n=t.elements,s=1/Hs.setFromMatrixColumn(t,0).length(),r=1/Hs.setFromMatrixColumn(t,1).length(),o=1/Hs.setFromMatrixColumn(t,2).length();return e[0]=n[0]*s,e[1]=n[1]*s,e[2]=n[2]*s,e[3]=0,e[4]=n[4]*r,e[5]=n[5]*r,e[6]=n[6]*r,e[7]=0,e[8]=n[8]*o,e[9]=n[9]*o,e[10]=n[10]*o,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromEuler(t){let e=this.elements,n=t.x,s=t.y,r=t.z,o=Math.cos(n),a=Math.sin(n),c=Math.cos(s),l=Math.sin(s),h=Math.cos(r),u=Math.sin(r);if(t.order==="XYZ"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=c*h,e[4]=-c*u,e[8]=l,e[1]=f+p*l,e[5]=d-x*l,e[9]=-a*c,e[2]=x-d*l,e[6]=p+f*l,e[10]=o*c}else if(t.order==="YXZ"){let d=c*h,f=c*u,p=l*h,x=l*u;e[0]=d+x*a,e[4]=p*a-f,e[8]=o*l,e[1]=o*u,e[5]=o*h,e[9]=-a,e[2]=f*a-p,e[6]=x+d*a,e[10]=o*c}else if(t.order==="ZXY"){let d=c*h,f=c*u,p=l*h,x=l*u;e[0]=d-x*a,e[4]=-o*u,e[8]=p+f*a,e[1]=f+p*a,e[5]=o*h,e[9]=x-d*a,e[2]=-o*l,e[6]=a,e[10]=o*c}else if(t.order==="ZYX"){let d=o*h,f=o*u,p=a*h,x=a*u;e[0]=c*h,e[4]=p*l-f,e[8]=d*l+x,e[1]=c*u,e[5]=x*l+d,e[9]=f*l-p,e[2]=-l,e[6]=a*c,e[10]=o*c}else if(t.order==="YZX"){let d=o*c,f=o*l,p=a*c,x=a*l;e[0]=c*h,e[4]=x-d*u,e[8]=p*u+f,e[1]=u,e[5]=o*h,e[9]=-a*h,e[2]=-l*h,e[6]=f*u+p,e[10]=d-x*u}else if(t.order==="XZY"){let d=o*c,f=o*l,p=a*c,x=a*l;e[0]=c*h,e[4]=-u,e[8]=l*h,e[1]=d*u+x,e[5]=o*h,e[9]=f*u-p,e[2]=p*u-f,e[6]=a*h,e[10]=x*u+d}return e[3]=0,e[7]=0,e[11]=0,e[12]=0,e[13]=0,e[14]=0,e[15]=1,this}makeRotationFromQuaternion(t){return this.compose(g0,t,x0)}lookAt(t,e,n){let s=this.elements;return Sn.subVectors(t,e),Sn.lengthSq()===0&&(Sn.z=1),Sn.normalize(),Xi.crossVectors(n,Sn),Xi.lengthSq()===0&&(Math.abs(n.z)===1?Sn.x+=1e-4:Sn.z+=1e-4,Sn.normalize(),Xi.crossVectors(n,Sn)),Xi.normalize(),ua.crossVectors(Sn,Xi),s[0]=Xi.x,s[4]=ua.x,s[8]=Sn.x,s[1]=Xi.y,s[5]=ua.y,s[9]=Sn.y,s[2]=Xi.z,s[6]=ua.z,s[10]=Sn.z,this}multiply(t){return this.multiplyMatrices(this,t)}premultiply(t){return this.multiplyMatrices(t,this)}multiplyMatrices(t,e){let n=t.elements,s=e.elements,r=this.elements,o=n[0],a=n[4],c=n[8],l=n[12],h=n[1],u=n[5],d=n[9],f=n[13],p=n[2],x=n[6],m=n[10],g=n[14],y=n[3],S=n[7],v=n[11],A=n[15],w=s[0],_=s[4],M=s[8],C=s[12],T=s[1],L=s[5],N=s[9],F=s[13],P=s[2],B=s[6],G=s[10],H=s[14],j=s[3],W=s[7],Y=s[11],tt=s[15];return r[0]=o*w+a*T+c*P+l*j,r[4]=o*_+a*L+c*B+l*W,r[8]=o*M+a*N+c*G+l*Y,r[12]=o*C+a*F+c*H+l*tt,r[1]=h*w+u*T+d*P+f*j,r[5]=h*_+u*L+d*B+f*W,r[9]=h*M+u*N+d*G+f*Y,r[13]=h*C+u*F+d*H+f*tt,r[2]=p*w+x*T+m*P+g*j,r[6]=p*_+x*L+m*B+g*W,r[10]=p*M+x*N+m*G+g*Y,r[14]=p*C+x*F+m*H+g*tt,r[3]=y*w+S*T+v*P+A*j,r[7]=y*_+S*L+v*B+A*W,r[11]=y*M+S*N+v*G+A*Y,r[15]=y*C+S*F+v*H+A*tt,this}multiplyScalar(t){let e=this.elements;return e[0]*=t,e[4]*=t,e[8]*=t,e[12]*=t,e[1]*=t,e[5]*=t,e[9]*=t,e[13]*=t,e[2]*=t,e[6]*=t,e[10]*=t,e[14]*=t,e[3]*=t,e[7]*=t,e[11]*=t,e[15]*=t,this}determinant(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[12],o=t[1],a=t[5],c=t[9],l=t[13],h=t[2],u=t[6],d=t[10],f=t[14],p=t[3],x=t[7],m=t[11],g=t[15],y=c*f-l*d,S=a*f-l*u,v=a*d-c*u,A=o*f-l*h,w=o*d-c*h,_=o*u-a*h;return e*(x*y-m*S+g*v)-n*(p*y-m*A+g*w)+s*(p*S-x*A+g*_)-r*(p*v-x*w+m*_)}determinantAffine(){let t=this.elements,e=t[0],n=t[4],s=t[8],r=t[1],o=t[5],a=t[9],c=t[2],l=t[6],h=t[10];return e*(o*h-a*l)-n*(r*h-a*c)+s*(r*l-o*c)}transpose(){let t=this.elements,e;return e=t[1],t[1]=t[4],t[4]=e,e=t[2],t[2]=t[8],t[8]=e,e=t[6],t[6]=t[9],t[9]=e,e=t[3],t[3]=t[12],t[12]=e,e=t[7],t[7]=t[13],t[13]=e,e=t[11],t[11]=t[14],t[14]=e,this}setPosition(t,e,n){let s=this.elements;return t.isVector3?(s[12]=t.x,s[13]=t.y,s[14]=t.z):(s[12]=t,s[13]=e,s[14]=n),this}invert(){let t=this.elements,e=t[0],n=t[1],s=t[2],r=t[3],o=t[4],a=t[5],c=t[6],l=t[7],h=t[8],u=t[9],d=t[10],f=t[11],p=t[12],x=t[13],m=t[14],g=t[15],y=e*a-n*o,S=e*c-s*o,v=e*l-r*o,A=n*c-s*a,w=n*l-r*a,_=s*l-r*c,M=h*x-u*p,C=h*m-d*p,T=h*g-f*p,L=u*m-d*x,N=u*g-f*x,F=d*g-f*m,P=y*F-S*N+v*L+A*T-w*C+_*M;if(P===0)return this.set(0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0);let B=1/P;return t[0]=(a*F-c*N+l*L)*B,t[1]=(s*N-n*F-r*L)*B,t[2]=(x*_-m*w+g*A)*B,t[3]=(d*w-u*_-f*A)*B,t[4]=(c*T-o*F-l*C)*B,t[5]=(e*F-s*T+r*C)*B,t[6]=(m*v-p*_-g*S)*B,t[7]=(h*_-d*v+f*S)*B,t[8]=(o*N-a*T+l*M)*B,t[9]=(n*T-e*N-r*M)*B,t[10]=(p*w-x*v+g*y)*B,t[11]=(u*v-h*w-f*y)*B,t[12]=(a*C-o*L-c*M)*B,t[13]=(e*L-n*C+s*M)*B,t[14]=(x*S-p*A-m*y)*B,t[15]=(h*A-u*S+d*y)*B,this}scale(t){let e=this.elements,n=t.x,s=t.y,r=t.z;return e[0]*=n,e[4]*=s,e[8]*=r,e[1]*=n,e[5]*=s,e[9]*=r,e[2]*=n,e[6]*=s,e[10]*=r,e[3]*=n,e[7]*=s,e[11]*=r,this}getMaxScaleOnAxis(){let t=this.elements,e=t[0]*t[0]+t[1]*t[1]+t[2]*t[2],n=t[4]*t[4]+t[5]*t[5]+t[6]*t[6],s=t[8]*t[8]+t[9]*t[9]+t[10]*t[10];return Math.sqrt(Math.max(e,n,s))}makeTranslation(t,e,n){return t.isVector3?this.set(1,0,0,t.x,0,1,0,t.y,0,0,1,t.z,0,0,0,1):this.set(1,0,0,t,0,1,0,e,0,0,1,n,0,0,0,1),this}makeRotationX(t){let e=Math.cos(t),n=Math.sin(t);return this.set(1,0,0,0,0,e,-n,0,0,n,e,0,0,0,0,1),this}makeRotationY(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,0,n,0,0,1,0,0,-n,0,e,0,0,0,0,1),this}makeRotationZ(t){let e=Math.cos(t),n=Math.sin(t);return this.set(e,-n,0,0,n,e,0,0,0,0,1,0,0,0,0,1),this}makeRotationAxis(t,e){let n=Math.cos(e),s=Math.sin(e),r=1-n,o=t.x,a=t.y,c=t.z,l=r*o,h=r*a;return this.set(l*o+n,l*a-s*c,l*c+s*a,0,l*a+s*c,h*a+n,h*c-s*o,0,l*c-s*a,h*c+s*o,r*c*c+n,0,0,0,0,1),this}makeScale(t,e,n){return this.set(t,0,0,0,0,e,0,0,0,0,n,0,0,0,0,1),this}makeShear(t,e,n,s,r,o){return this.set(1,n,r,0,t,1,o,0,e,s,1,0,0,0,0,1),this}compose(t,e,n){let s=this.elements,r=e._x,o=e._y,a=e._z,c=e._w,l=r+r,h=o+o,u=a+a,d=r*l,f=r*h,p=r*u,x=o*h,m=o*u,g=a*u,y=c*l,S=c*h,v=c*u,A=n.x,w=n.y,_=n.z;return s[0]=(1-(x+g))*A,s[1]=(f+v)*A,s[2]=(p-S)*A,s[3]=0,s[4]=(f-v)*w,s[5]=(1-(d+g))*w,s[6]=(m+y)*w,s[7]=0,s[8]=(p+S)*_,s[9]=(m-y)*_,s[10]=(1-(d+x))*_,s[11]=0,s[12]=t.x,s[13]=t.y,s[14]=t.z,s[15]=1,this}decompose(t,e,n){let s=this.elements;t.x=s[12],t.y=s[13],t.z=s[14];let r=this.determinantAffine();if(r===0)return n.set(1,1,1),e.identity(),this;let o=Hs.set(s[0],s[1],s[2]).length(),a=Hs.set(s[4],s[5],s[6]).length(),c=Hs.set(s[8],s[9],s[10]).length();r<0&&(o=-o),$n.copy(this);let l=1/o,h=1/a,u=1/c;return $n.elements[0]*=l,$n.elements[1]*=l,$n.elements[2]*=l,$n.elements[4]*=h,$n.elements[5]*=h,$n.elements[6]*=h,$n.elements[8]*=u,$n.elements[9]*=u,$n.elements[10]*=u,e.setFromRotationMatrix($n),n.x=o,n.y=a,n.z=c,this}makePerspective(t,e,n,s,r,o,a=Bn,c=!1){let l=this.elements,h=2*r/(e-t),u=2*r/(n-s),d=(e+t)/(e-t),f=(n+s)/(n-s),p,x;if(c)p=r/(o-r),x=o*r/(o-r);else if(a===Bn)p=-(o+r)/(o-r),x=-2*o*r/(o-r);else if(a===ar)p=-o/(o-r),x=-o*r/(o-r);else throw new Error("THREE.Matrix4.makePerspective(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=d,l[12]=0,l[1]=0,l[5]=u,l[9]=f,l[13]=0,l[2]=0,l[6]=0,l[10]=p,l[14]=x,l[3]=0,l[7]=0,l[11]=-1,l[15]=0,this}makeOrthographic(t,e,n,s,r,o,a=Bn,c=!1){let l=this.elements,h=2/(e-t),u=2/(n-s),d=-(e+t)/(e-t),f=-(n+s)/(n-s),p,x;if(c)p=1/(o-r),x=o/(o-r);else if(a===Bn)p=-2/(o-r),x=-(o+r)/(o-r);else if(a===ar)p=-1/(o-r),x=-r/(o-r);else throw new Error("THREE.Matrix4.makeOrthographic(): Invalid coordinate system: "+a);return l[0]=h,l[4]=0,l[8]=0,l[12]=d,l[1]=0,l[5]=u,l[9]=0,l[13]=f,l[2]=0,l[6]=0,l[10]=p,l[14]=x,l[3]=0,l[7]=0,l[11]=0,l[15]=1,this}equals(t){let e=this.elements,n=t.elements;for(let s=0;s<16;s++)if(e[s]!==n[s])return!1;return!0}fromArray(t,e=0){for(let n=0;n<16;n++)this.elements[n]=t[n+e];return this}toArray(t=[],e=0){let n=this.elements;return t[e]=n[0],t[e+1]=n[1],t[e+2]=n[2],t[e+3]=n[3],t[e+4]=n[4],t[e+5]=n[5],t[e+6]=n[6],t[e+7]=n[7],t[e+8]=n[8],t[e+9]=n[9],t[e+10]=n[10],t[e+11]=n[11],t[e+12]=n[12],t[e+13]=n[13],t[e+14]=n[14],t[e+15]=n[15],t}},Hs=new I,$n=new te,g0=new I(0,0,0),x0=new I(1,1,1),Xi=new I,ua=new I,Sn=new I,Od=new te,Fd=new ae,Pi=class i{constructor(t=0,e=0,n=0,s=i.DEFAULT_ORDER){this.isEuler=!0,this._x=t,this._y=e,this._z=n,this._order=s}get x(){return this._x}set x(t){this._x=t,this._onChangeCallback()}get y(){return this._y}set y(t){this._y=t,this._onChangeCallback()}get z(){return this._z}set z(t){this._z=t,this._onChangeCallback()}get order(){return this._order}set order(t){this._order=t,this._onChangeCallback()}set(t,e,n,s=this._order){return this._x=t,this._y=e,this._z=n,this._order=s,this._onChangeCallback(),this}clone(){return new this.constructor(this._x,this._y,this._z,this._order)}copy(t){return this._x=t._x,this._y=t._y,this._z=t._z,this._order=t._order,this._onChangeCallback(),this}setFromRotationMatrix(t,e=this._order,n=!0){let s=t.elements,r=s[0],o=s[4],a=s[8],c=s[1],l=s[5],h=s[9],u=s[2],d=s[6],f=s[10];switch(e){case"XYZ":this._y=Math.asin(Gt(a,-1,1)),Math.abs(a)<.9999999?(this._x=Math.atan2(-h,f),this._z=Math.atan2(-o,r)):(this._x=Math.atan2(d,l),this._z=0);break;case"YXZ":this._x=Math.asin(-Gt(h,-1,1)),Math.abs(h)<.9999999?(this._y=Math.atan2(a,f),this._z=Math.atan2(c,l)):(this._y=Math.atan2(-u,r),this._z=0);break;case"ZXY":this._x=Math.asin(Gt(d,-1,1)),Math.abs(d)<.9999999?(this._y=Math.atan2(-u,f),this._z=Math.atan2(-o,l)):(this._y=0,this._z=Math.atan2(c,r));break;case"ZYX":this._y=Math.asin(-Gt(u,-1,1)),Math.abs(u)<.9999999?(this._x=Math.atan2(d,f),this._z=Math.atan2(c,r)):(this._x=0,this._z=Math.atan2(-o,l));break;case"YZX":this._z=Math.asin(Gt(c,-1,1)),Math.abs(c)<.9999999?(this._x=Math.atan2(-h,l),this._y=Math.atan2(-u,r)):(this._x=0,this._y=Math.atan2(a,f));break;case"XZY":this._z=Math.asin(-Gt(o,-1,1)),Math.abs(o)<.9999999?(this._x=Math.atan2(d,l),this._y=Math.atan2(a,r)):(this._x=Math.atan2(-h,f),this._y=0);break;default:It("Euler: .setFromRotationMatrix() encountered an unknown order: "+e)}return this._order=e,n===!0&&this._onChangeCallback(),this}setFromQuaternion(t,e,n){return Od.makeRotationFromQuaternion(t),this.setFromRotationMatrix(Od,e,n)}setFromVector3(t,e=this._order){return this.set(t.x,t.y,t.z,e)}reorder(t){return Fd.setFromEuler(this),this.setFromQuaternion(Fd,t)}equals(t){return t._x===this._x&&t._y===this._y&&t._z===this._z&&t._order===this._order}fromArray(t){return this._x=t[0],this._y=t[1],this._z=t[2],t[3]!==void 0&&(this._order=t[3]),this._onChangeCallback(),this}toArray(t=[],e=0){return t[e]=this._x,t[e+1]=this._y,t[e+2]=this._z,t[e+3]=this._order,t}_onChange(t){return this._onChangeCallback=t,this}_onChangeCallback(){}*[Symbol.iterator](){yield this._x,yield this._y,yield this._z,yield this._order}};Pi.DEFAULT_ORDER="XYZ";var ao=class{constructor(){this.mask=1}set(t){this.mask=(1<<t|0)>>>0}enable(t){this.mask|=1<<t|0}enableAll(){this.mask=-1}toggle(t){this.mask^=1<<t|0}disable(t){this.mask&=~(1<<t|0)}disableAll(){this.mask=0}test(t){return(this.mask&t.mask)!==0}isEnabled(t){return(this.mask&(1<<t|0))!==0}},_0=0,Bd=new I,Ws=new ae,Si=new te,da=new I,Xr=new I,y0=new I,v0=new ae,zd=new I(1,0,0),kd=new I(0,1,0),Gd=new I(0,0,1),Vd={type:"added"},M0={type:"removed"},qs={type:"childadded",child:null},ph={type:"childremoved",child:null},$e=class i extends ci{constructor(){super(),this.isObject3D=!0,Object.defineProperty(this,"id",{value:_0++}),this.uuid=os(),this.name="",this.type="Object3D",this.parent=null,this.children=[],this.up=i.DEFAULT_UP.clone();let t=new I,e=new Pi,n=new ae,s=new I(1,1,1);function r(){n.setFromEuler(e,!1)}function o(){e.setFromQuaternion(n,void 0,!1)}e._onChange(r),n._onChange(o),Object.defineProperties(this,{position:{configurable:!0,enumerable:!0,value:t},rotation:{configurable:!0,enumerable:!0,value:e},quaternion:{configurable:!0,enumerable:!0,value:n},scale:{configurable:!0,enumerable:!0,value:s},modelViewMatrix:{value:new te},normalMatrix:{value:new Ot}}),this.matrix=new te,this.matrixWorld=new te,this.matrixAutoUpdate=i.DEFAULT_MATRIX_AUTO_UPDATE,this.matrixWorldAutoUpdate=i.DEFAULT_MATRIX_WORLD_AUTO_UPDATE,this.matrixWorldNeedsUpdate=!1,this.layers=new ao,this.visible=!0,this.castShadow=!1,this.receiveShadow=!1,this.frustumCulled=!0,this.renderOrder=0,this.animations=[],this.customDepthMaterial=void 0,this.customDistanceMaterial=void 0,this.static=!1,this.userData={},this.pivot=null}onBeforeShadow(){}onAfterShadow(){}onBeforeRender(){}onAfterRender(){}applyMatrix4(t){this.matrixAutoUpdate&&this.updateMatrix(),this.matrix.premultiply(t),this.matrix.decompose(this.position,this.quaternion,this.scale),this.pivot!==null&&this.position.copy(this.pivot).applyMatrix4(this.matrix).sub(this.pivot)}applyQuaternion(t){return this.quaternion.premultiply(t),this}setRotationFromAxisAngle(t,e){this.quaternion.setFromAxisAngle(t,e)}setRotationFromEuler(t){this.quaternion.setFromEuler(t,!0)}setRotationFromMatrix(t){this.quaternion.setFromRotationMatrix(t)}setRotationFromQuaternion(t){this.quaternion.copy(t)}rotateOnAxis(t,e){return Ws.setFromAxisAngle(t,e),this.quaternion.multiply(Ws),this}rotateOnWorldAxis(t,e){return Ws.setFromAxisAngle(t,e),this.quaternion.premultiply(Ws),this}rotateX(t){return this.rotateOnAxis(zd,t)}rotateY(t){return this.rotateOnAxis(kd,t)}rotateZ(t){return this.rotateOnAxis(Gd,t)}translateOnAxis(t,e){return Bd.copy(t).applyQuaternion(this.quaternion),this.position.add(Bd.multiplyScalar(e)),this}translateX(t){return this.translateOnAxis(zd,t)}translateY(t){return this.translateOnAxis(kd,t)}translateZ(t){return this.translateOnAxis(Gd,t)}localToWorld(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(this.matrixWorld)}worldToLocal(t){return this.updateWorldMatrix(!0,!1),t.applyMatrix4(Si.copy(this.matrixWorld).invert())}lookAt(t,e,n){t.isVector3?da.copy(t):da.set(t,e,n);let s=this.parent;this.updateWorldMatrix(!0,!1),Xr.setFromMatrixPosition(this.matrixWorld),this.isCamera||this.isLight?Si.lookAt(Xr,da,this.up):Si.lookAt(da,Xr,this.up),this.quaternion.setFromRotationMatrix(Si),s&&(Si.extractRotation(s.matrixWorld),Ws.setFromRotationMatrix(Si),this.quaternion.premultiply(Ws.invert()))}add(t){if(arguments.length>1){for(let e=0;e<arguments.length;e++)this.add(arguments[e]);return this}return t===this?(Ut("Object3D.add: object can't be added as a child of itself.",t),this):(t&&t.isObject3D?(t.removeFromParent(),t.parent=this,this.children.push(t),t.dispatchEvent(Vd),qs.child=t,this.dispatchEvent(qs),qs.child=null):Ut("Object3D.add: object not an instance of THREE.Object3D.",t),this)}remove(t){if(arguments.length>1){for(let n=0;n<arguments.length;n++)this.remove(arguments[n]);return this}let e=this.children.indexOf(t);return e!==-1&&(t.parent=null,this.children.splice(e,1),t.dispatchEvent(M0),ph.child=t,this.dispatchEvent(ph),ph.child=null),this}removeFromParent(){let t=this.parent;return t!==null&&t.remove(this),this}clear(){return this.remove(...this.children)}attach(t){return this.updateWorldMatrix(!0,!1),Si.copy(this.matrixWorld).invert(),t.parent!==null&&(t.parent.updateWorldMatrix(!0,!1),Si.multiply(t.parent.matrixWorld)),t.applyMatrix4(Si),t.removeFromParent(),t.parent=this,this.children.push(t),t.updateWorldMatrix(!1,!0),t.dispatchEvent(Vd),qs.child=t,this.dispatchEvent(qs),qs.child=null,this}getObjectById(t){return this.getObjectByProperty("id",t)}getObjectByName(t){return this.getObjectByProperty("name",t)}getObjectByProperty(t,e){if(this[t]===e)return this;for(let n=0,s=this.children.length;n<s;n++){let o=this.children[n].getObjectByProperty(t,e);if(o!==void 0)return o}}getObjectsByProperty(t,e,n=[]){this[t]===e&&n.push(this);let s=this.children;for(let r=0,o=s.length;r<o;r++)s[r].getObjectsByProperty(t,e,n);return n}getWorldPosition(t){return this.updateWorldMatrix(!0,!1),t.setFromMatrixPosition(this.matrixWorld)}getWorldQuaternion(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xr,t,y0),t}getWorldScale(t){return this.updateWorldMatrix(!0,!1),this.matrixWorld.decompose(Xr,v0,t),t}getWorldDirection(t){this.updateWorldMatrix(!0,!1);let e=this.matrixWorld.elements;return t.set(e[8],e[9],e[10]).normalize()}raycast(){}intersectsFrustum(){return!0}traverse(t){t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverse(t)}traverseVisible(t){if(this.visible===!1)return;t(this);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].traverseVisible(t)}traverseAncestors(t){let e=this.parent;e!==null&&(t(e),e.traverseAncestors(t))}updateMatrix(){this.matrix.compose(this.position,this.quaternion,this.scale);let t=this.pivot;if(t!==null){let e=t.x,n=t.y,s=t.z,r=this.matrix.elements;r[12]+=e-r[0]*e-r[4]*n-r[8]*s,r[13]+=n-r[1]*e-r[5]*n-r[9]*s,r[14]+=s-r[2]*e-r[6]*n-r[10]*s}this.matrixWorldNeedsUpdate=!0}updateMatrixWorld(t){this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||t)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,t=!0);let e=this.children;for(let n=0,s=e.length;n<s;n++)e[n].updateMatrixWorld(t)}updateWorldMatrix(t,e,n=!1){let s=this.parent;if(t===!0&&s!==null&&s.updateWorldMatrix(!0,!1),this.matrixAutoUpdate&&this.updateMatrix(),(this.matrixWorldNeedsUpdate||n)&&(this.matrixWorldAutoUpdate===!0&&(this.parent===null?this.matrixWorld.copy(this.matrix):this.matrixWorld.multiplyMatrices(this.parent.matrixWorld,this.matrix)),this.matrixWorldNeedsUpdate=!1,n=!0),e===!0){let r=this.children;for(let o=0,a=r.length;o<a;o++)r[o].updateWorldMatrix(!1,!0,n)}}toJSON(t){let e=t===void 0||typeof t=="string",n={};e&&(t={geometries:{},materials:{},textures:{},images:{},shapes:{},skeletons:{},animations:{},nodes:{}},n.metadata={version:4.7,type:"Object",generator:"Object3D.toJSON"});let s={};s.uuid=this.uuid,s.type=this.type,s.name=this.name,s.castShadow=this.castShadow,s.receiveShadow=this.receiveShadow,s.visible=this.visible,s.frustumCulled=this.frustumCulled,s.renderOrder=this.renderOrder,s.static=this.static,s.matrixAutoUpdate=this.matrixAutoUpdate,Object.keys(this.userData).length>0&&(s.userData=this.userData),s.layers=this.layers.mask,s.matrix=this.matrix.toArray(),s.up=this.up.toArray(),this.pivot!==null&&(s.pivot=this.pivot.toArray()),this.morphTargetDictionary!==void 0&&(s.morphTargetDictionary=Object.assign({},this.morphTargetDictionary)),this.morphTargetInfluences!==void 0&&(s.morphTargetInfluences=this.morphTargetInfluences.slice()),this.isInstancedMesh&&(s.type="InstancedMesh",s.count=this.count,s.instanceMatrix=this.instanceMatrix.toJSON(),this.instanceColor!==null&&(s.instanceColor=this.instanceColor.toJSON())),this.isBatchedMesh&&(s.type="BatchedMesh",s.perObjectFrustumCulled=this.perObjectFrustumCulled,s.sortObjects=this.sortObjects,s.drawRanges=this._drawRanges,s.reservedRanges=this._reservedRanges,s.geometryInfo=this._geometryInfo.map(a=>({...a,boundingBox:a.boundingBox?a.boundingBox.toJSON():void 0,boundingSphere:a.boundingSphere?a.boundingSphere.toJSON():void 0})),s.instanceInfo=this._instanceInfo.map(a=>({...a})),s.availableInstanceIds=this._availableInstanceIds.slice(),s.availableGeometryIds=this._availableGeometryIds.slice(),s.nextIndexStart=this._nextIndexStart,s.nextVertexStart=this._nextVertexStart,s.geometryCount=this._geometryCount,s.maxInstanceCount=this._maxInstanceCount,s.maxVertexCount=this._maxVertexCount,s.maxIndexCount=this._maxIndexCount,s.geometryInitialized=this._geometryInitialized,s.matricesTexture=this._matricesTexture.toJSON(t),s.indirectTexture=this._indirectTexture.toJSON(t),this._colorsTexture!==null&&(s.colorsTexture=this._colorsTexture.toJSON(t)),this.boundingSphere!==null&&(s.boundingSphere=this.boundingSphere.toJSON()),this.boundingBox!==null&&(s.boundingBox=this.boundingBox.toJSON()));function r(a,c){return a[c.uuid]===void 0&&(a[c.uuid]=c.toJSON(t)),c.uuid}if(this.isScene)this.background&&(this.background.isColor?s.background=this.background.toJSON():this.background.isTexture&&(s.background=this.background.toJSON(t).uuid)),this.environment&&this.environment.isTexture&&this.environment.isRenderTargetTexture!==!0&&(s.environment=this.environment.toJSON(t).uuid);else if(this.isMesh||this.isLine||this.isPoints){s.geometry=r(t.geometries,this.geometry);let a=this.geometry.parameters;if(a!==void 0&&a.shapes!==void 0){let c=a.shapes;if(Array.isArray(c))for(let l=0,h=c.length;l<h;l++){let u=c[l];r(t.shapes,u)}else r(t.shapes,c)}}if(this.isSkinnedMesh&&(s.bindMode=this.bindMode,s.bindMatrix=this.bindMatrix.toArray(),this.skeleton!==void 0&&(r(t.skeletons,this.skeleton),s.skeleton=this.skeleton.uuid)),this.material!==void 0)if(Array.isArray(this.material)){let a=[];for(let c=0,l=this.material.length;c<l;c++)a.push(r(t.materials,this.material[c]));s.material=a}else s.material=r(t.materials,this.material);if(this.children.length>0){s.children=[];for(let a=0;a<this.children.length;a++)s.children.push(this.children[a].toJSON(t).object)}if(this.animations.length>0){s.animations=[];for(let a=0;a<this.animations.length;a++){let c=this.animations[a];s.animations.push(r(t.animations,c))}}if(e){let a=o(t.geometries),c=o(t.materials),l=o(t.textures),h=o(t.images),u=o(t.shapes),d=o(t.skeletons),f=o(t.animations),p=o(t.nodes);a.length>0&&(n.geometries=a),c.length>0&&(n.materials=c),l.length>0&&(n.textures=l),h.length>0&&(n.images=h),u.length>0&&(n.shapes=u),d.length>0&&(n.skeletons=d),f.length>0&&(n.animations=f),p.length>0&&(n.nodes=p)}return n.object=s,n;function o(a){let c=[];for(let l in a){let h=a[l];delete h.metadata,c.push(h)}return c}}clone(t){return new this.constructor().copy(this,t)}copy(t,e=!0){if(this.name=t.name,this.up.copy(t.up),this.position.copy(t.position),this.rotation.order=t.rotation.order,this.quaternion.copy(t.quaternion),this.scale.copy(t.scale),this.pivot=t.pivot!==null?t.pivot.clone():null,this.matrix.copy(t.matrix),this.matrixWorld.copy(t.matrixWorld),this.matrixAutoUpdate=t.matrixAutoUpdate,this.matrixWorldAutoUpdate=t.matrixWorldAutoUpdate,this.matrixWorldNeedsUpdate=t.matrixWorldNeedsUpdate,this.layers.mask=t.layers.mask,this.visible=t.visible,this.castShadow=t.castShadow,this.receiveShadow=t.receiveShadow,this.frustumCulled=t.frustumCulled,this.renderOrder=t.renderOrder,this.static=t.static,this.animations=t.animations.slice(),this.userData=JSON.parse(JSON.stringify(t.userData)),e===!0)for(let n=0;n<t.children.length;n++){let s=t.children[n];this.add(s.clone())}return this}dispose(){this.dispatchEvent({type:"dispose"})}};$e.DEFAULT_UP=new I(0,1,0);$e.DEFAULT_MATRIX_AUTO_UPDATE=!0;$e.DEFAULT_MATRIX_WORLD_AUTO_UPDATE=!0;var ye=class extends $e{constructor(){super(),this.isGroup=!0,this.type="Group"}},S0={type:"move"},ur=class{constructor(){this._targetRay=null,this._grip=null,this._hand=null}getHandSpace(){return this._hand===null&&(this._hand=new ye,this._hand.matrixAutoUpdate=!1,this._hand.visible=!1,this._hand.joints={},this._hand.inputState={pinching:!1}),this._hand}getTargetRaySpace(){return this._targetRay===null&&(this._targetRay=new ye,this._targetRay.matrixAutoUpdate=!1,this._targetRay.visible=!1,this._targetRay.hasLinearVelocity=!1,this._targetRay.linearVelocity=new I,this._targetRay.hasAngularVelocity=!1,this._targetRay.angularVelocity=new I),this._targetRay}getGripSpace(){return this._grip===null&&(this._grip=new ye,this._grip.matrixAutoUpdate=!1,this._grip.visible=!1,this._grip.hasLinearVelocity=!1,this._grip.linearVelocity=new I,this._grip.hasAngularVelocity=!1,this._grip.angularVelocity=new I,this._grip.eventsEnabled=!1),this._grip}dispatchEvent(t){return this._targetRay!==null&&this._targetRay.dispatchEvent(t),this._grip!==null&&this._grip.dispatchEvent(t),this._hand!==null&&this._hand.dispatchEvent(t),this}connect(t){if(t&&t.hand){let e=this._hand;if(e)for(let n of t.hand.values())this._getHandJoint(e,n)}return this.dispatchEvent({type:"connected",data:t}),this}disconnect(t){return this.dispatchEvent({type:"disconnected",data:t}),this._targetRay!==null&&(this._targetRay.visible=!1),this._grip!==null&&(this._grip.visible=!1),this._hand!==null&&(this._hand.visible=!1),this}update(t,e,n){let s=null,r=null,o=null,a=this._targetRay,c=this._grip,l=this._hand;if(t&&e.session.visibilityState!=="visible-blurred"){if(l&&t.hand){o=!0;for(let x of t.hand.values()){let m=e.getJointPose(x,n),g=this._getHandJoint(l,x);m!==null&&(g.matrix.fromArray(m.transform.matrix),g.matrix.decompose(g.position,g.quaternion,g.scale),g.matrixWorldNeedsUpdate=!0,g.jointRadius=m.radius),g.visible=m!==null}let h=l.joints["index-finger-tip"],u=l.joints["thumb-tip"],d=h.position.distanceTo(u.position),f=.02,p=.005;l.inputState.pinching&&d>f+p?(l.inputState.pinching=!1,this.dispatchEvent({type:"pinchend",handedness:t.handedness,target:this})):!l.inputState.pinching&&d<=f-p&&(l.inputState.pinching=!0,this.dispatchEvent({type:"pinchstart",handedness:t.handedness,target:this}))}else c!==null&&t.gripSpace&&(r=e.getPose(t.gripSpace,n),r!==null&&(c.matrix.fromArray(r.transform.matrix),c.matrix.decompose(c.position,c.quaternion,c.scale),c.matrixWorldNeedsUpdate=!0,r.linearVelocity?(c.hasLinearVelocity=!0,c.linearVelocity.copy(r.linearVelocity)):c.hasLinearVelocity=!1,r.angularVelocity?(c.hasAngularVelocity=!0,c.angularVelocity.copy(r.angularVelocity)):c.hasAngularVelocity=!1,c.eventsEnabled&&c.dispatchEvent({type:"gripUpdated",data:t,target:this})));a!==null&&(s=e.getPose(t.targetRaySpace,n),s===null&&r!==null&&(s=r),s!==null&&(a.matrix.fromArray(s.transform.matrix),a.matrix.decompose(a.position,a.quaternion,a.scale),a.matrixWorldNeedsUpdate=!0,s.linearVelocity?(a.hasLinearVelocity=!0,a.linearVelocity.copy(s.linearVelocity)):a.hasLinearVelocity=!1,s.angularVelocity?(a.hasAngularVelocity=!0,a.angularVelocity.copy(s.angularVelocity)):a.hasAngularVelocity=!1,this.dispatchEvent(S0)))}return a!==null&&(a.visible=s!==null),c!==null&&(c.visible=r!==null),l!==null&&(l.visible=o!==null),this}_getHandJoint(t,e){if(t.joints[e.jointName]===void 0){let n=new ye;n.matrixAutoUpdate=!1,n.visible=!1,t.joints[e.jointName]=n,t.add(n)}return t.joints[e.jointName]}},Zf={aliceblue:15792383,antiquewhite:16444375,aqua:65535,aquamarine:8388564,azure:15794175,beige:16119260,bisque:16770244,black:0,blanchedalmond:16772045,blue:255,blueviolet:9055202,brown:10824234,burlywood:14596231,cadetblue:6266528,chartreuse:8388352,chocolate:13789470,coral:16744272,cornflowerblue:6591981,cornsilk:16775388,crimson:14423100,cyan:65535,darkblue:139,darkcyan:35723,darkgoldenrod:12092939,darkgray:11119017,darkgreen:25600,darkgrey:11119017,darkkhaki:12433259,darkmagenta:9109643,darkolivegreen:5597999,darkorange:16747520,darkorchid:10040012,darkred:9109504,darksalmon:15308410,darkseagreen:9419919,darkslateblue:4734347,darkslategray:3100495,darkslategrey:3100495,darkturquoise:52945,darkviolet:9699539,deeppink:16716947,deepskyblue:49151,dimgray:6908265,dimgrey:6908265,dodgerblue:2003199,firebrick:11674146,floralwhite:16775920,forestgreen:2263842,fuchsia:16711935,gainsboro:14474460,ghostwhite:16316671,gold:16766720,goldenrod:14329120,gray:8421504,green:32768,greenyellow:11403055,grey:8421504,honeydew:15794160,hotpink:16738740,indianred:13458524,indigo:4915330,ivory:16777200,khaki:15787660,lavender:15132410,lavenderblush:16773365,lawngreen:8190976,lemonchiffon:16775885,lightblue:11393254,lightcoral:15761536,lightcyan:14745599,lightgoldenrodyellow:16448210,lightgray:13882323,lightgreen:9498256,lightgrey:13882323,lightpink:16758465,lightsalmon:16752762,lightseagreen:2142890,lightskyblue:8900346,lightslategray:7833753,lightslategrey:7833753,lightsteelblue:11584734,lightyellow:16777184,lime:65280,limegreen:3329330,linen:16445670,magenta:16711935,maroon:8388608,mediumaquamarine:6737322,mediumblue:205,mediumorchid:12211667,mediumpurple:9662683,mediumseagreen:3978097,mediumslateblue:8087790,mediumspringgreen:64154,mediumturquoise:4772300,mediumvioletred:13047173,midnightblue:1644912,mintcream:16121850,mistyrose:16770273,moccasin:16770229,navajowhite:16768685,navy:128,oldlace:16643558,olive:8421376,olivedrab:7048739,orange:16753920,orangered:16729344,orchid:14315734,palegoldenrod:15657130,palegreen:10025880,paleturquoise:11529966,palevioletred:14381203,papayawhip:16773077,peachpuff:16767673,peru:13468991,pink:16761035,plum:14524637,powderblue:11591910,purple:8388736,rebeccapurple:6697881,red:16711680,rosybrown:12357519,royalblue:4286945,saddlebrown:9127187,salmon:16416882,sandybrown:16032864,seagreen:3050327,seashell:16774638,sienna:10506797,silver:12632256,skyblue:8900331,slateblue:6970061,slategray:7372944,slategrey:7372944,snow:16775930,springgreen:65407,steelblue:4620980,tan:13808780,teal:32896,thistle:14204888,tomato:16737095,turquoise:4251856,violet:15631086,wheat:16113331,white:16777215,whitesmoke:16119285,yellow:16776960,yellowgreen:10145074},$i={h:0,s:0,l:0},fa={h:0,s:0,l:0};function mh(i,t,e){return e<0&&(e+=1),e>1&&(e-=1),e<1/6?i+(t-i)*6*e:e<1/2?t:e<2/3?i+(t-i)*6*(2/3-e):i}var zt=class{constructor(t,e,n){return this.isColor=!0,this.r=1,this.g=1,this.b=1,this.set(t,e,n)}set(t,e,n){if(e===void 0&&n===void 0){let s=t;s&&s.isColor?this.copy(s):typeof s=="number"?this.setHex(s):typeof s=="string"&&this.setStyle(s)}else this.setRGB(t,e,n);return this}setScalar(t){return this.r=t,this.g=t,this.b=t,this}setHex(t,e=wn){return t=Math.floor(t),this.r=(t>>16&255)/255,this.g=(t>>8&255)/255,this.b=(t&255)/255,Kt.colorSpaceToWorking(this,e),this}setRGB(t,e,n,s=Kt.workingColorSpace){return this.r=t,this.g=e,this.b=n,Kt.colorSpaceToWorking(this,s),this}setHSL(t,e,n,s=Kt.workingColorSpace){if(t=du(t,1),e=Gt(e,0,1),n=Gt(n,0,1),e===0)this.r=this.g=this.b=n;else{let r=n<=.5?n*(1+e):n+e-n*e,o=2*n-r;this.r=mh(o,r,t+1/3),this.g=mh(o,r,t),this.b=mh(o,r,t-1/3)}return Kt.colorSpaceToWorking(this,s),this}setStyle(t,e=wn){function n(r){r!==void 0&&parseFloat(r)<1&&It("Color: Alpha component of "+t+" will be ignored.")}let s;if(s=/^(\w+)\(([^\)]*)\)/.exec(t)){let r,o=s[1],a=s[2];switch(o){case"rgb":case"rgba":if(r=/^\s*(\d+)\s*,\s*(\d+)\s*,\s*(\d+)\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(255,parseInt(r[1],10))/255,Math.min(255,parseInt(r[2],10))/255,Math.min(255,parseInt(r[3],10))/255,e);if(r=/^\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setRGB(Math.min(100,parseFloat(r[1]))/100,Math.min(100,parseFloat(r[2]))/100,Math.min(100,parseFloat(r[3]))/100,e);break;case"hsl":case"hsla":if(r=/^\s*([+-]?(?:\d+(?:\.\d+)?|\.\d+))\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*,\s*(\d+(?:\.\d+)?|\.\d+)\%\s*(?:,\s*(\d+(?:\.\d+)?|\.\d+)\s*)?$/.exec(a))return n(r[4]),this.setHSL(parseFloat(r[1])/360,parseFloat(r[2])/100,parseFloat(r[3])/100,e);break;default:It("Color: Unknown color model "+t)}}else if(s=/^\#([A-Fa-f\d]+)$/.exec(t)){let r=s[1],o=r.length;if(o===3)return this.setRGB(parseInt(r.charAt(0),16)/15,parseInt(r.charAt(1),16)/15,parseInt(r.charAt(2),16)/15,e);if(o===6)return this.setHex(parseInt(r,16),e);It("Color: Invalid hex color "+t)}else if(t&&t.length>0)return this.setColorName(t,e);return this}setColorName(t,e=wn){let n=Zf[t.toLowerCase()];return n!==void 0?this.setHex(n,e):It("Color: Unknown color "+t),this}clone(){return new this.constructor(this.r,this.g,this.b)}copy(t){return this.r=t.r,this.g=t.g,this.b=t.b,this}copySRGBToLinear(t){return this.r=Ri(t.r),this.g=Ri(t.g),this.b=Ri(t.b),this}copyLinearToSRGB(t){return this.r=rr(t.r),this.g=rr(t.g),this.b=rr(t.b),this}convertSRGBToLinear(){return this.copySRGBToLinear(this),this}convertLinearToSRGB(){return this.copyLinearToSRGB(this),this}getHex(t=wn){return Kt.workingToColorSpace(nn.copy(this),t),Math.round(Gt(nn.r*255,0,255))*65536+Math.round(Gt(nn.g*255,0,255))*256+Math.round(Gt(nn.b*255,0,255))}getHexString(t=wn){return("000000"+this.getHex(t).toString(16)).slice(-6)}getHSL(t,e=Kt.workingColorSpace){Kt.workingToColorSpace(nn.copy(this),e);let n=nn.r,s=nn.g,r=nn.b,o=Math.max(n,s,r),a=Math.min(n,s,r),c,l,h=(a+o)/2;if(a===o)c=0,l=0;else{let u=o-a;switch(l=h<=.5?u/(o+a):u/(2-o-a),o){case n:c=(s-r)/u+(s<r?6:0);break;case s:c=(r-n)/u+2;break;case r:c=(n-s)/u+4;break}c/=6}return t.h=c,t.s=l,t.l=h,t}getRGB(t,e=Kt.workingColorSpace){return Kt.workingToColorSpace(nn.copy(this),e),t.r=nn.r,t.g=nn.g,t.b=nn.b,t}getStyle(t=wn){Kt.workingToColorSpace(nn.copy(this),t);let e=nn.r,n=nn.g,s=nn.b;return t!==wn?`color(${t} ${e.toFixed(3)} ${n.toFixed(3)} ${s.toFixed(3)})`:`rgb(${Math.round(e*255)},${Math.round(n*255)},${Math.round(s*255)})`}offsetHSL(t,e,n){return this.getHSL($i),this.setHSL($i.h+t,$i.s+e,$i.l+n)}add(t){return this.r+=t.r,this.g+=t.g,this.b+=t.b,this}addColors(t,e){return this.r=t.r+e.r,this.g=t.g+e.g,this.b=t.b+e.b,this}addScalar(t){return this.r+=t,this.g+=t,this.b+=t,this}sub(t){return this.r=Math.max(0,this.r-t.r),this.g=Math.max(0,this.g-t.g),this.b=Math.max(0,this.b-t.b),this}multiply(t){return this.r*=t.r,this.g*=t.g,this.b*=t.b,this}multiplyScalar(t){return this.r*=t,this.g*=t,this.b*=t,this}lerp(t,e){return this.r+=(t.r-this.r)*e,this.g+=(t.g-this.g)*e,this.b+=(t.b-this.b)*e,this}lerpColors(t,e,n){return this.r=t.r+(e.r-t.r)*n,this.g=t.g+(e.g-t.g)*n,this.b=t.b+(e.b-t.b)*n,this}lerpHSL(t,e){this.getHSL($i),t.getHSL(fa);let n=to($i.h,fa.h,e),s=to($i.s,fa.s,e),r=to($i.l,fa.l,e);return this.setHSL(n,s,r),this}setFromVector3(t){return this.r=t.x,this.g=t.y,this.b=t.z,this}applyMatrix3(t){let e=this.r,n=this.g,s=this.b,r=t.elements;return this.r=r[0]*e+r[3]*n+r[6]*s,this.g=r[1]*e+r[4]*n+r[7]*s,this.b=r[2]*e+r[5]*n+r[8]*s,this}equals(t){return t.r===this.r&&t.g===this.g&&t.b===this.b}fromArray(t,e=0){return this.r=t[e],this.g=t[e+1],this.b=t[e+2],this}toArray(t=[],e=0){return t[e]=this.r,t[e+1]=this.g,t[e+2]=this.b,t}fromBufferAttribute(t,e){return this.r=t.getX(e),this.g=t.getY(e),this.b=t.getZ(e),this}toJSON(){return this.getHex()}*[Symbol.iterator](){yield this.r,yield this.g,yield this.b}},nn=new zt;zt.NAMES=Zf;var co=class extends $e{constructor(){super(),this.isScene=!0,this.type="Scene",this.background=null,this.environment=null,this.fog=null,this.backgroundBlurriness=0,this.backgroundIntensity=1,this.backgroundRotation=new Pi,this.environmentIntensity=1,this.environmentRotation=new Pi,this.overrideMaterial=null,typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}copy(t,e){return super.copy(t,e),this.background=t.background!==null?t.background.clone():null,this.environment=t.environment!==null?t.environment.clone():null,this.fog=t.fog!==null?t.fog.clone():null,this.backgroundBlurriness=t.backgroundBlurriness,this.backgroundIntensity=t.backgroundIntensity,this.backgroundRotation.copy(t.backgroundRotation),this.environmentIntensity=t.environmentIntensity,this.environmentRotation.copy(t.environmentRotation),this.overrideMaterial=t.overrideMaterial!==null?t.overrideMaterial.clone():null,this.matrixAutoUpdate=t.matrixAutoUpdate,this}toJSON(t){let e=super.toJSON(t);return this.fog!==null&&(e.object.fog=this.fog.toJSON()),e.object.backgroundBlurriness=this.backgroundBlurriness,e.object.backgroundIntensity=this.backgroundIntensity,e.object.backgroundRotation=this.backgroundRotation.toArray(),e.object.environmentIntensity=this.environmentIntensity,e.object.environmentRotation=this.environmentRotation.toArray(),e}},Yn=new I,bi=new I,gh=new I,wi=new I,Xs=new I,$s=new I,Hd=new I,xh=new I,_h=new I,yh=new I,vh=new ce,Mh=new ce,Sh=new ce,Ti=class i{constructor(t=new I,e=new I,n=new I){this.a=t,this.b=e,this.c=n}static getNormal(t,e,n,s){s.subVectors(n,e),Yn.subVectors(t,e),s.cross(Yn);let r=s.lengthSq();return r>0?s.multiplyScalar(1/Math.sqrt(r)):s.set(0,0,0)}static getBarycoord(t,e,n,s,r){Yn.subVectors(s,e),bi.subVectors(n,e),gh.subVectors(t,e);let o=Yn.dot(Yn),a=Yn.dot(bi),c=Yn.dot(gh),l=bi.dot(bi),h=bi.dot(gh),u=o*l-a*a;if(u===0)return r.set(0,0,0),null;let d=1/u,f=(l*c-a*h)*d,p=(o*h-a*c)*d;return r.set(1-f-p,p,f)}static containsPoint(t,e,n,s){return this.getBarycoord(t,e,n,s,wi)===null?!1:wi.x>=0&&wi.y>=0&&wi.x+wi.y<=1}static getInterpolation(t,e,n,s,r,o,a,c){return this.getBarycoord(t,e,n,s,wi)===null?(c.x=0,c.y=0,"z"in c&&(c.z=0),"w"in c&&(c.w=0),null):(c.setScalar(0),c.addScaledVector(r,wi.x),c.addScaledVector(o,wi.y),c.addScaledVector(a,wi.z),c)}static getInterpolatedAttribute(t,e,n,s,r,o){return vh.setScalar(0),Mh.setScalar(0),Sh.setScalar(0),vh.fromBufferAttribute(t,e),Mh.fromBufferAttribute(t,n),Sh.fromBufferAttribute(t,s),o.setScalar(0),o.addScaledVector(vh,r.x),o.addScaledVector(Mh,r.y),o.addScaledVector(Sh,r.z),o}static isFrontFacing(t,e,n,s){return Yn.subVectors(n,e),bi.subVectors(t,e),Yn.cross(bi).dot(s)<0}set(t,e,n){return this.a.copy(t),this.b.copy(e),this.c.copy(n),this}setFromPointsAndIndices(t,e,n,s){return this.a.copy(t[e]),this.b.copy(t[n]),this.c.copy(t[s]),this}setFromAttributeAndIndices(t,e,n,s){return this.a.fromBufferAttribute(t,e),this.b.fromBufferAttribute(t,n),this.c.fromBufferAttribute(t,s),this}clone(){return new this.constructor().copy(this)}copy(t){return this.a.copy(t.a),this.b.copy(t.b),this.c.copy(t.c),this}getArea(){return Yn.subVectors(this.c,this.b),bi.subVectors(this.a,this.b),Yn.cross(bi).length()*.5}getMidpoint(t){return t.addVectors(this.a,this.b).add(this.c).multiplyScalar(1/3)}getNormal(t){return i.getNormal(this.a,this.b,this.c,t)}getPlane(t){return t.setFromCoplanarPoints(this.a,this.b,this.c)}getBarycoord(t,e){return i.getBarycoord(t,this.a,this.b,this.c,e)}getInterpolation(t,e,n,s,r){return i.getInterpolation(t,this.a,this.b,this.c,e,n,s,r)}containsPoint(t){return i.containsPoint(t,this.a,this.b,this.c)}isFrontFacing(t){return i.isFrontFacing(this.a,this.b,this.c,t)}intersectsBox(t){return t.intersectsTriangle(this)}closestPointToPoint(t,e){let n=this.a,s=this.b,r=this.c,o,a;Xs.subVectors(s,n),$s.subVectors(r,n),xh.subVectors(t,n);let c=Xs.dot(xh),l=$s.dot(xh);if(c<=0&&l<=0)return e.copy(n);_h.subVectors(t,s);let h=Xs.dot(_h),u=$s.dot(_h);if(h>=0&&u<=h)return e.copy(s);let d=c*u-h*l;if(d<=0&&c>=0&&h<=0&&c-h>0)return o=c/(c-h),e.copy(n).addScaledVector(Xs,o);yh.subVectors(t,r);let f=Xs.dot(yh),p=$s.dot(yh);if(p>=0&&f<=p)return e.copy(r);let x=f*l-c*p;if(x<=0&&l>=0&&p<=0)return a=l/(l-p),e.copy(n).addScaledVector($s,a);let m=h*p-f*u;if(m<=0&&u-h>=0&&f-p>=0)return Hd.subVectors(r,s),a=(u-h)/(u-h+(f-p)),e.copy(s).addScaledVector(Hd,a);let g=1/(m+x+d);return o=x*g,a=d*g,e.copy(n).addScaledVector(Xs,o).addScaledVector($s,a)}equals(t){return t.a.equals(this.a)&&t.b.equals(this.b)&&t.c.equals(this.c)}},ln=class{constructor(t=new I(1/0,1/0,1/0),e=new I(-1/0,-1/0,-1/0)){this.isBox3=!0,this.min=t,this.max=e}set(t,e){return this.min.copy(t),this.max.copy(e),this}setFromArray(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e+=3)this.expandByPoint(Zn.fromArray(t,e));return this}setFromBufferAttribute(t){this.makeEmpty();for(let e=0,n=t.count;e<n;e++)this.expandByPoint(Zn.fromBufferAttribute(t,e));return this}setFromPoints(t){this.makeEmpty();for(let e=0,n=t.length;e<n;e++)this.expandByPoint(t[e]);return this}setFromCenterAndSize(t,e){let n=Zn.copy(e).multiplyScalar(.5);return this.min.copy(t).sub(n),this.max.copy(t).add(n),this}setFromObject(t,e=!1){return this.makeEmpty(),this.expandByObject(t,e)}clone(){return new this.constructor().copy(this)}copy(t){return this.min.copy(t.min),this.max.copy(t.max),this}makeEmpty(){return this.min.x=this.min.y=this.min.z=1/0,this.max.x=this.max.y=this.max.z=-1/0,this}isEmpty(){return this.max.x<this.min.x||this.max.y<this.min.y||this.max.z<this.min.z}getCenter(t){return this.isEmpty()?t.set(0,0,0):t.addVectors(this.min,this.max).multiplyScalar(.5)}getSize(t){return this.isEmpty()?t.set(0,0,0):t.subVectors(this.max,this.min)}expandByPoint(t){return this.min.min(t),this.max.max(t),this}expandByVector(t){return this.min.sub(t),this.max.add(t),this}expandByScalar(t){return this.min.addScalar(-t),this.max.addScalar(t),this}expandByObject(t,e=!1){t.updateWorldMatrix(!1,!1);let n=t.geometry;if(n!==void 0){let r=n.getAttribute("position");if(e===!0&&r!==void 0&&t.isInstancedMesh!==!0&&t.isBatchedMesh!==!0)for(let o=0,a=r.count;o<a;o++)t.isMesh===!0?t.getVertexPosition(o,Zn):Zn.fromBufferAttribute(r,o),Zn.applyMatrix4(t.matrixWorld),this.expandByPoint(Zn);else t.boundingBox!==void 0?(t.boundingBox===null&&t.computeBoundingBox(),pa.copy(t.boundingBox)):(n.boundingBox===null&&n.computeBoundingBox(),pa.copy(n.boundingBox)),pa.applyMatrix4(t.matrixWorld),this.union(pa)}let s=t.children;for(let r=0,o=s.length;r<o;r++)this.expandByObject(s[r],e);return this}containsPoint(t){return t.x>=this.min.x&&t.x<=this.max.x&&t.y>=this.min.y&&t.y<=this.max.y&&t.z>=this.min.z&&t.z<=this.max.z}containsBox(t){return this.min.x<=t.min.x&&t.max.x<=this.max.x&&this.min.y<=t.min.y&&t.max.y<=this.max.y&&this.min.z<=t.min.z&&t.max.z<=this.max.z}getParameter(t,e){return e.set((t.x-this.min.x)/(this.max.x-this.min.x),(t.y-this.min.y)/(this.max.y-this.min.y),(t.z-this.min.z)/(this.max.z-this.min.z))}intersectsBox(t){return t.max.x>=this.min.x&&t.min.x<=this.max.x&&t.max.y>=this.min.y&&t.min.y<=this.max.y&&t.max.z>=this.min.z&&t.min.z<=this.max.z}intersectsSphere(t){return this.clampPoint(t.center,Zn),Zn.distanceToSquared(t.center)<=t.radius*t.radius}intersectsPlane(t){let e,n;return t.normal.x>0?(e=t.normal.x*this.min.x,n=t.normal.x*this.max.x):(e=t.normal.x*this.max.x,n=t.normal.x*this.min.x),t.normal.y>0?(e+=t.normal.y*this.min.y,n+=t.normal.y*this.max.y):(e+=t.normal.y*this.max.y,n+=t.normal.y*this.min.y),t.normal.z>0?(e+=t.normal.z*this.min.z,n+=t.normal.z*this.max.z):(e+=t.normal.z*this.max.z,n+=t.normal.z*this.min.z),e<=-t.constant&&n>=-t.constant}intersectsTriangle(t){if(this.isEmpty())return!1;this.getCenter($r),ma.subVectors(this.max,$r),Ys.subVectors(t.a,$r),Zs.subVectors(t.b,$r),Js.subVectors(t.c,$r),Yi.subVectors(Zs,Ys),Zi.subVectors(Js,Zs),Ts.subVectors(Ys,Js);let e=[0,-Yi.z,Yi.y,0,-Zi.z,Zi.y,0,-Ts.z,Ts.y,Yi.z,0,-Yi.x,Zi.z,0,-Zi.x,Ts.z,0,-Ts.x,-Yi.y,Yi.x,0,-Zi.y,Zi.x,0,-Ts.y,Ts.x,0];return!bh(e,Ys,Zs,Js,ma)||(e=[1,0,0,0,1,0,0,0,1],!bh(e,Ys,Zs,Js,ma))?!1:(ga.crossVectors(Yi,Zi),e=[ga.x,ga.y,ga.z],bh(e,Ys,Zs,Js,ma))}clampPoint(t,e){return e.copy(t).clamp(this.min,this.max)}distanceToPoint(t){return this.clampPoint(t,Zn).distanceTo(t)}getBoundingSphere(t){return this.isEmpty()?t.makeEmpty():(this.getCenter(t.center),t.radius=this.getSize(Zn).length()*.5),t}intersect(t){return this.min.max(t.min),this.max.min(t.max),this.isEmpty()&&this.makeEmpty(),this}union(t){return this.min.min(t.min),this.max.max(t.max),this}applyMatrix4(t){return this.isEmpty()?this:(Ai[0].set(this.min.x,this.min.y,this.min.z).applyMatrix4(t),Ai[1].set(this.min.x,this.min.y,this.max.z).applyMatrix4(t),Ai[2].set(this.min.x,this.max.y,this.min.z).applyMatrix4(t),Ai[3].set(this.min.x,this.max.y,this.max.z).applyMatrix4(t),Ai[4].set(this.max.x,this.min.y,this.min.z).applyMatrix4(t),Ai[5].set(this.max.x,this.min.y,this.max.z).applyMatrix4(t),Ai[6].set(this.max.x,this.max.y,this.min.z).applyMatrix4(t),Ai[7].set(this.max.x,this.max.y,this.max.z).applyMatrix4(t),this.setFromPoints(Ai),this)}translate(t){return this.min.add(t),this.max.add(t),this}equals(t){return t.min.equals(this.min)&&t.max.equals(this.max)}toJSON(){return{min:this.min.toArray(),max:this.max.toArray()}}fromJSON(t){return this.min.fromArray(t.min),this.max.fromArray(t.max),this}},Ai=[new I,new I,new I,new I,new I,new I,new I,new I],Zn=new I,pa=new ln,Ys=new I,Zs=new I,Js=new I,Yi=new I,Zi=new I,Ts=new I,$r=new I,ma=new I,ga=new I,Rs=new I;function bh(i,t,e,n,s){for(let r=0,o=i.length-3;r<=o;r+=3){Rs.fromArray(i,r);let a=s.x*Math.abs(Rs.x)+s.y*Math.abs(Rs.y)+s.z*Math.abs(Rs.z),c=t.dot(Rs),l=e.dot(Rs),h=n.dot(Rs);if(Math.max(-Math.max(c,l,h),Math.min(c,l,h))>a)return!1}return!0}var Ne=new I,xa=new Wt,b0=0,De=class extends ci{constructor(t,e,n=!1){if(super(),Array.isArray(t))throw new TypeError("THREE.BufferAttribute: array should be a Typed Array.");this.isBufferAttribute=!0,Object.defineProperty(this,"id",{value:b0++}),this.name="",this.array=t,this.itemSize=e,this.count=t!==void 0?t.length/e:0,this.normalized=n,this.usage=hu,this.updateRanges=[],this.gpuType=Gn,this.version=0,this._normalizationScale=t!==void 0?cl(t):void 0}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.name=t.name,this.array=new t.array.constructor(t.array),this.itemSize=t.itemSize,this.count=t.count,this.normalized=t.normalized,this.usage=t.usage,this.gpuType=t.gpuType,this._normalizationScale=t._normalizationScale,this}copyAt(t,e,n){t*=this.itemSize,n*=e.itemSize;for(let s=0,r=this.itemSize;s<r;s++)this.array[t+s]=e.array[n+s];return this}copyArray(t){return this.array.set(t),this}applyMatrix3(t){if(this.itemSize===2)for(let e=0,n=this.count;e<n;e++)xa.fromBufferAttribute(this,e),xa.applyMatrix3(t),this.setXY(e,xa.x,xa.y);else if(this.itemSize===3)for(let e=0,n=this.count;e<n;e++)Ne.fromBufferAttribute(this,e),Ne.applyMatrix3(t),this.setXYZ(e,Ne.x,Ne.y,Ne.z);return this}applyMatrix4(t){for(let e=0,n=this.count;e<n;e++)Ne.fromBufferAttribute(this,e),Ne.applyMatrix4(t),this.setXYZ(e,Ne.x,Ne.y,Ne.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)Ne.fromBufferAttribute(this,e),Ne.applyNormalMatrix(t),this.setXYZ(e,Ne.x,Ne.y,Ne.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)Ne.fromBufferAttribute(this,e),Ne.transformDirection(t),this.setXYZ(e,Ne.x,Ne.y,Ne.z);return this}set(t,e=0){return this.array.set(t,e),this}getComponent(t,e){let n=this.array[t*this.itemSize+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.array[t*this.itemSize+e]=n,this}getX(t){let e=this.array[t*this.itemSize];return this.normalized&&(e=this._denormalize(e)),e}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize]=e,this}getY(t){let e=this.array[t*this.itemSize+1];return this.normalized&&(e=this._denormalize(e)),e}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+1]=e,this}getZ(t){let e=this.array[t*this.itemSize+2];return this.normalized&&(e=this._denormalize(e)),e}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+2]=e,this}getW(t){let e=this.array[t*this.itemSize+3];return this.normalized&&(e=this._denormalize(e)),e}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.array[t*this.itemSize+3]=e,this}setXY(t,e,n){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.array[t+0]=e,this.array[t+1]=n,this}setXYZ(t,e,n,s){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t*=this.itemSize,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.array[t+0]=e,this.array[t+1]=n,this.array[t+2]=s,this.array[t+3]=r,this}onUpload(t){return this.onUploadCallback=t,this}clone(){return new this.constructor(this.array,this.itemSize).copy(this)}toJSON(){let t={itemSize:this.itemSize,type:this.array.constructor.name,array:Array.from(this.array),normalized:this.normalized};return t.name=this.name,t.usage=this.usage,t.gpuType=this.gpuType,t}dispose(){this.dispatchEvent({type:"dispose"})}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):pu(t,this.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):mu(t,this.array)}};var lo=class extends De{constructor(t,e,n){super(new Uint16Array(t),e,n)}};var ho=class extends De{constructor(t,e,n){super(new Uint32Array(t),e,n)}};var re=class extends De{constructor(t,e,n){super(new Float32Array(t),e,n)}},w0=new ln,Yr=new I,wh=new I,xn=class{constructor(t=new I,e=-1){this.isSphere=!0,this.center=t,this.radius=e}set(t,e){return this.center.copy(t),this.radius=e,this}setFromPoints(t,e){let n=this.center;e!==void 0?n.copy(e):w0.setFromPoints(t).getCenter(n);let s=0;for(let r=0,o=t.length;r<o;r++)s=Math.max(s,n.distanceToSquared(t[r]));return this.radius=Math.sqrt(s),this}copy(t){return this.center.copy(t.center),this.radius=t.radius,this}isEmpty(){return this.radius<0}makeEmpty(){return this.center.set(0,0,0),this.radius=-1,this}containsPoint(t){return t.distanceToSquared(this.center)<=this.radius*this.radius}distanceToPoint(t){return t.distanceTo(this.center)-this.radius}intersectsSphere(t){let e=this.radius+t.radius;return t.center.distanceToSquared(this.center)<=e*e}intersectsBox(t){return t.intersectsSphere(this)}intersectsPlane(t){return Math.abs(t.distanceToPoint(this.center))<=this.radius}clampPoint(t,e){let n=this.center.distanceToSquared(t);return e.copy(t),n>this.radius*this.radius&&(e.sub(this.center).normalize(),e.multiplyScalar(this.radius).add(this.center)),e}getBoundingBox(t){return this.isEmpty()?(t.makeEmpty(),t):(t.set(this.center,this.center),t.expandByScalar(this.radius),t)}applyMatrix4(t){return this.center.applyMatrix4(t),this.radius=this.radius*t.getMaxScaleOnAxis(),this}translate(t){return this.center.add(t),this}expandByPoint(t){if(this.isEmpty())return this.center.copy(t),this.radius=0,this;Yr.subVectors(t,this.center);let e=Yr.lengthSq();if(e>this.radius*this.radius){let n=Math.sqrt(e),s=(n-this.radius)*.5;this.center.addScaledVector(Yr,s/n),this.radius+=s}return this}union(t){return t.isEmpty()?this:this.isEmpty()?(this.copy(t),this):(this.center.equals(t.center)===!0?this.radius=Math.max(this.radius,t.radius):(wh.subVectors(t.center,this.center).setLength(t.radius),this.expandByPoint(Yr.copy(t.center).add(wh)),this.expandByPoint(Yr.copy(t.center).sub(wh))),this)}equals(t){return t.center.equals(this.center)&&t.radius===this.radius}clone(){return new this.constructor().copy(this)}toJSON(){return{radius:this.radius,center:this.center.toArray()}}fromJSON(t){return this.radius=t.radius,this.center.fromArray(t.center),this}},A0=0,Fn=new te,Ah=new $e,Ks=new I,bn=new ln,Zr=new ln,Ve=new I,Ee=class i extends ci{constructor(){super(),this.isBufferGeometry=!0,Object.defineProperty(this,"id",{value:A0++}),this.uuid=os(),this.name="",this.type="BufferGeometry",this.index=null,this.indirect=null,this.indirectOffset=0,this.attributes={},this.morphAttributes={},this.morphTargetsRelative=!1,this.groups=[],this.boundingBox=null,this.boundingSphere=null,this.drawRange={start:0,count:1/0},this.userData={},this._transformed=!1}getIndex(){return this.index}setIndex(t){return Array.isArray(t)?this.index=new(Jg(t)?ho:lo)(t,1):this.index=t,this}setIndirect(t,e=0){return this.indirect=t,this.indirectOffset=e,this}getIndirect(){return this.indirect}getAttribute(t){return this.attributes[t]}setAttribute(t,e){return this.attributes[t]=e,this}deleteAttribute(t){return delete this.attributes[t],this}hasAttribute(t){return this.attributes[t]!==void 0}addGroup(t,e,n=0){this.groups.push({start:t,count:e,materialIndex:n})}clearGroups(){this.groups=[]}setDrawRange(t,e){this.drawRange.start=t,this.drawRange.count=e}applyMatrix4(t){let e=this.attributes.position;e!==void 0&&(e.applyMatrix4(t),e.needsUpdate=!0);let n=this.attributes.normal;if(n!==void 0){let r=new Ot().getNormalMatrix(t);n.applyNormalMatrix(r),n.needsUpdate=!0}let s=this.attributes.tangent;return s!==void 0&&(s.transformDirection(t),s.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this._transformed=!0,this}applyQuaternion(t){return Fn.makeRotationFromQuaternion(t),this.applyMatrix4(Fn),this}rotateX(t){return Fn.makeRotationX(t),this.applyMatrix4(Fn),this}rotateY(t){return Fn.makeRotationY(t),this.applyMatrix4(Fn),this}rotateZ(t){return Fn.makeRotationZ(t),this.applyMatrix4(Fn),this}translate(t,e,n){return Fn.makeTranslation(t,e,n),this.applyMatrix4(Fn),this}scale(t,e,n){return Fn.makeScale(t,e,n),this.applyMatrix4(Fn),this}lookAt(t){return Ah.lookAt(t),Ah.updateMatrix(),this.applyMatrix4(Ah.matrix),this}center(){return this.computeBoundingBox(),this.boundingBox.getCenter(Ks).negate(),this.translate(Ks.x,Ks.y,Ks.z),this}setFromPoints(t){let e=this.getAttribute("position");if(e===void 0){let n=[];for(let s=0,r=t.length;s<r;s++){let o=t[s];n.push(o.x,o.y,o.z||0)}this.setAttribute("position",new re(n,3))}else{let n=Math.min(t.length,e.count);for(let s=0;s<n;s++){let r=t[s];e.setXYZ(s,r.x,r.y,r.z||0)}t.length>e.count&&It("BufferGeometry: Buffer size too small for points data. Use .dispose() and create a new geometry."),e.needsUpdate=!0}return this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ln);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ut("BufferGeometry.computeBoundingBox(): GLBufferAttribute requires a manual bounding box.",this),this.boundingBox.set(new I(-1/0,-1/0,-1/0),new I(1/0,1/0,1/0));return}if(t!==void 0){if(this.boundingBox.setFromBufferAttribute(t),e)for(let n=0,s=e.length;n<s;n++){let r=e[n];bn.setFromBufferAttribute(r),this.morphTargetsRelative?(Ve.addVectors(this.boundingBox.min,bn.min),this.boundingBox.expandByPoint(Ve),Ve.addVectors(this.boundingBox.max,bn.max),this.boundingBox.expandByPoint(Ve)):(this.boundingBox.expandByPoint(bn.min),this.boundingBox.expandByPoint(bn.max))}}else this.boundingBox.makeEmpty();(isNaN(this.boundingBox.min.x)||isNaN(this.boundingBox.min.y)||isNaN(this.boundingBox.min.z))&&Ut('BufferGeometry.computeBoundingBox(): Computed min/max have NaN values. The "position" attribute is likely to have NaN values.',this)}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new xn);let t=this.attributes.position,e=this.morphAttributes.position;if(t&&t.isGLBufferAttribute){Ut("BufferGeometry.computeBoundingSphere(): GLBufferAttribute requires a manual bounding sphere.",this),this.boundingSphere.set(new I,1/0);return}if(t){let n=this.boundingSphere.center;if(bn.setFromBufferAttribute(t),e)for(let r=0,o=e.length;r<o;r++){let a=e[r];Zr.setFromBufferAttribute(a),this.morphTargetsRelative?(Ve.addVectors(bn.min,Zr.min),bn.expandByPoint(Ve),Ve.addVectors(bn.max,Zr.max),bn.expandByPoint(Ve)):(bn.expandByPoint(Zr.min),bn.expandByPoint(Zr.max))}bn.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Ve.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Ve));if(e)for(let r=0,o=e.length;r<o;r++){let a=e[r],c=this.morphTargetsRelative;for(let l=0,h=a.count;l<h;l++)Ve.fromBufferAttribute(a,l),c&&(Ks.fromBufferAttribute(t,l),Ve.add(Ks)),s=Math.max(s,n.distanceToSquared(Ve))}this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&Ut('BufferGeometry.computeBoundingSphere(): Computed radius is NaN. The "position" attribute is likely to have NaN values.',this)}}computeTangents(){let t=this.index,e=this.attributes;if(t===null||e.position===void 0||e.normal===void 0||e.uv===void 0){Ut("BufferGeometry: .computeTangents() failed. Missing required attributes (index, position, normal or uv)");return}let n=e.position,s=e.normal,r=e.uv,o=this.getAttribute("tangent");(o===void 0||o.count!==n.count)&&(o=new De(new Float32Array(4*n.count),4),this.setAttribute("tangent",o));let a=[],c=[],l=new Uint8Array(n.count);for(let C=0;C<n.count;C++)a[C]=new I,c[C]=new I;let h=new I,u=new I,d=new I,f=new Wt,p=new Wt,x=new Wt,m=new I,g=new I;function y(C,T,L){l[C]=l[T]=l[L]=1,h.fromBufferAttribute(n,C),u.fromBufferAttribute(n,T),d.fromBufferAttribute(n,L),f.fromBufferAttribute(r,C),p.fromBufferAttribute(r,T),x.fromBufferAttribute(r,L),u.sub(h),d.sub(h),p.sub(f),x.sub(f);let N=1/(p.x*x.y-x.x*p.y);isFinite(N)&&(m.copy(u).multiplyScalar(x.y).addScaledVector(d,-p.y).multiplyScalar(N),g.copy(d).multiplyScalar(p.x).addScaledVector(u,-x.x).multiplyScalar(N),a[C].add(m),a[T].add(m),a[L].add(m),c[C].add(g),c[T].add(g),c[L].add(g))}let S=this.groups;S.length===0&&(S=[{start:0,count:t.count}]);for(let C=0,T=S.length;C<T;++C){let L=S[C],N=L.start,F=L.count;for(let P=N,B=N+F;P<B;P+=3)y(t.getX(P+0),t.getX(P+1),t.getX(P+2))}let v=new I,A=new I,w=new I,_=new I;function M(C){w.fromBufferAttribute(s,C),_.copy(w);let T=a[C];v.copy(T),v.sub(w.multiplyScalar(w.dot(T))).normalize(),A.crossVectors(_,T);let N=A.dot(c[C])<0?-1:1;o.setXYZW(C,v.x,v.y,v.z,N)}for(let C=0,T=n.count;C<T;++C)l[C]&&M(C);this._transformed=!0}computeVertexNormals(){let t=this.index,e=this.getAttribute("position");if(e!==void 0){let n=this.getAttribute("normal");if(n===void 0||n.count!==e.count)n=new De(new Float32Array(e.count*3),3),this.setAttribute("normal",n);else for(let d=0,f=n.count;d<f;d++)n.setXYZ(d,0,0,0);let s=new I,r=new I,o=new I,a=new I,c=new I,l=new I,h=new I,u=new I;if(t)for(let d=0,f=t.count;d<f;d+=3){let p=t.getX(d+0),x=t.getX(d+1),m=t.getX(d+2);s.fromBufferAttribute(e,p),r.fromBufferAttribute(e,x),o.fromBufferAttribute(e,m),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),a.fromBufferAttribute(n,p),c.fromBufferAttribute(n,x),l.fromBufferAttribute(n,m),a.add(h),c.add(h),l.add(h),n.setXYZ(p,a.x,a.y,a.z),n.setXYZ(x,c.x,c.y,c.z),n.setXYZ(m,l.x,l.y,l.z)}else for(let d=0,f=e.count;d<f;d+=3)s.fromBufferAttribute(e,d+0),r.fromBufferAttribute(e,d+1),o.fromBufferAttribute(e,d+2),h.subVectors(o,r),u.subVectors(s,r),h.cross(u),n.setXYZ(d+0,h.x,h.y,h.z),n.setXYZ(d+1,h.x,h.y,h.z),n.setXYZ(d+2,h.x,h.y,h.z);this.normalizeNormals(),n.needsUpdate=!0}}normalizeNormals(){let t=this.attributes.normal;for(let e=0,n=t.count;e<n;e++)Ve.fromBufferAttribute(t,e),Ve.normalize(),t.setXYZ(e,Ve.x,Ve.y,Ve.z)}toNonIndexed(){function t(a,c){let l=a.array,h=a.itemSize,u=a.normalized,d=new l.constructor(c.length*h),f=0,p=0;for(let x=0,m=c.length;x<m;x++){a.isInterleavedBufferAttribute?f=c[x]*a.data.stride+a.offset:f=c[x]*h;for(let g=0;g<h;g++)d[p++]=l[f++]}return new De(d,h,u)}if(this.index===null)return It("BufferGeometry.toNonIndexed(): BufferGeometry is already non-indexed."),this;let e=new i,n=this.index.array,s=this.attributes;for(let a in s){let c=s[a],l=t(c,n);e.setAttribute(a,l)}let r=this.morphAttributes;for(let a in r){let c=[],l=r[a];for(let h=0,u=l.length;h<u;h++){let d=l[h],f=t(d,n);c.push(f)}e.morphAttributes[a]=c}e.morphTargetsRelative=this.morphTargetsRelative;let o=this.groups;for(let a=0,c=o.length;a<c;a++){let l=o[a];e.addGroup(l.start,l.count,l.materialIndex)}return e}toJSON(){let t={metadata:{version:4.7,type:"BufferGeometry",generator:"BufferGeometry.toJSON"}};if(t.uuid=this.uuid,t.type=this.parameters!==void 0&&this._transformed===!0?"BufferGeometry":this.type,t.name=this.name,Object.keys(this.userData).length>0&&(t.userData=this.userData),this.parameters!==void 0&&this._transformed!==!0){let c=this.parameters;for(let l in c)c[l]!==void 0&&(t[l]=c[l]);return t}t.data={attributes:{}};let e=this.index;e!==null&&(t.data.index={type:e.array.constructor.name,array:Array.prototype.slice.call(e.array)});let n=this.attributes;for(let c in n){let l=n[c];t.data.attributes[c]=l.toJSON(t.data)}let s={},r=!1;for(let c in this.morphAttributes){let l=this.morphAttributes[c],h=[];for(let u=0,d=l.length;u<d;u++){let f=l[u];h.push(f.toJSON(t.data))}h.length>0&&(s[c]=h,r=!0)}r&&(t.data.morphAttributes=s,t.data.morphTargetsRelative=this.morphTargetsRelative);let o=this.groups;o.length>0&&(t.data.groups=JSON.parse(JSON.stringify(o)));let a=this.boundingSphere;return a!==null&&(t.data.boundingSphere=a.toJSON()),t}clone(){return new this.constructor().copy(this)}copy(t){this.index=null,this.attributes={},this.morphAttributes={},this.groups=[],this.boundingBox=null,this.boundingSphere=null;let e={};this.name=t.name;let n=t.index;n!==null&&this.setIndex(n.clone());let s=t.attributes;for(let l in s){let h=s[l];this.setAttribute(l,h.clone(e))}let r=t.morphAttributes;for(let l in r){let h=[],u=r[l];for(let d=0,f=u.length;d<f;d++)h.push(u[d].clone(e));this.morphAttributes[l]=h}this.morphTargetsRelative=t.morphTargetsRelative;let o=t.groups;for(let l=0,h=o.length;l<h;l++){let u=o[l];this.addGroup(u.start,u.count,u.materialIndex)}let a=t.boundingBox;a!==null&&(this.boundingBox=a.clone());let c=t.boundingSphere;return c!==null&&(this.boundingSphere=c.clone()),this.drawRange.start=t.drawRange.start,this.drawRange.count=t.drawRange.count,this.userData=t.userData,this._transformed=t._transformed,this}dispose(){this.dispatchEvent({type:"dispose"})}},uo=class{constructor(t,e){this.isInterleavedBuffer=!0,this.array=t,this.stride=e,this.count=t!==void 0?t.length/e:0,this.usage=hu,this.updateRanges=[],this.version=0,this.uuid=os()}onUploadCallback(){}set needsUpdate(t){t===!0&&this.version++}setUsage(t){return this.usage=t,this}addUpdateRange(t,e){this.updateRanges.push({start:t,count:e})}clearUpdateRanges(){this.updateRanges.length=0}copy(t){return this.array=new t.array.constructor(t.array),this.count=t.count,this.stride=t.stride,this.usage=t.usage,this}copyAt(t,e,n){t*=this.stride,n*=e.stride;for(let s=0,r=this.stride;s<r;s++)this.array[t+s]=e.array[n+s];return this}set(t,e=0){return this.array.set(t,e),this}clone(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Wd(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=this.array.slice(0).buffer);let n=new this.array.constructor(t.arrayBuffers[e]),s=new this.constructor(n,this.stride);return s.setUsage(this.usage),s}onUpload(t){return this.onUploadCallback=t,this}toJSON(t){t.arrayBuffers===void 0&&(t.arrayBuffers={});let e=Wd(this.array);t.arrayBuffers[e]===void 0&&(t.arrayBuffers[e]=Array.from(new Uint32Array(this.array.slice(0).buffer)));let n={uuid:this.uuid,buffer:e,type:this.array.constructor.name,stride:this.stride};return n.usage=this.usage,n}};function Wd(i){return i.buffer._uuid===void 0&&(i.buffer._uuid=os()),i.byteOffset===0&&i.byteLength===i.buffer.byteLength?i.buffer._uuid:i.buffer._uuid+":"+i.byteOffset+":"+i.byteLength}var an=new I,zn=class i{constructor(t,e,n,s=!1){this.isInterleavedBufferAttribute=!0,this.name="",this.data=t,this.itemSize=e,this.offset=n,this.normalized=s,this._normalizationScale=t!==void 0?cl(t.array):void 0}get count(){return this.data.count}get array(){return this.data.array}set needsUpdate(t){this.data.needsUpdate=t}applyMatrix4(t){for(let e=0,n=this.data.count;e<n;e++)an.fromBufferAttribute(this,e),an.applyMatrix4(t),this.setXYZ(e,an.x,an.y,an.z);return this}applyNormalMatrix(t){for(let e=0,n=this.count;e<n;e++)an.fromBufferAttribute(this,e),an.applyNormalMatrix(t),this.setXYZ(e,an.x,an.y,an.z);return this}transformDirection(t){for(let e=0,n=this.count;e<n;e++)an.fromBufferAttribute(this,e),an.transformDirection(t),this.setXYZ(e,an.x,an.y,an.z);return this}getComponent(t,e){let n=this.array[t*this.data.stride+this.offset+e];return this.normalized&&(n=this._denormalize(n)),n}setComponent(t,e,n){return this.normalized&&(n=this._normalize(n)),this.data.array[t*this.data.stride+this.offset+e]=n,this}setX(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset]=e,this}setY(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+1]=e,this}setZ(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+2]=e,this}setW(t,e){return this.normalized&&(e=this._normalize(e)),this.data.array[t*this.data.stride+this.offset+3]=e,this}getX(t){let e=this.data.array[t*this.data.stride+this.offset];return this.normalized&&(e=this._denormalize(e)),e}getY(t){let e=this.data.array[t*this.data.stride+this.offset+1];return this.normalized&&(e=this._denormalize(e)),e}getZ(t){let e=this.data.array[t*this.data.stride+this.offset+2];return this.normalized&&(e=this._denormalize(e)),e}getW(t){let e=this.data.array[t*this.data.stride+this.offset+3];return this.normalized&&(e=this._denormalize(e)),e}setXY(t,e,n){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n)),this.data.array[t+0]=e,this.data.array[t+1]=n,this}setXYZ(t,e,n,s){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this}setXYZW(t,e,n,s,r){return t=t*this.data.stride+this.offset,this.normalized&&(e=this._normalize(e),n=this._normalize(n),s=this._normalize(s),r=this._normalize(r)),this.data.array[t+0]=e,this.data.array[t+1]=n,this.data.array[t+2]=s,this.data.array[t+3]=r,this}clone(t){if(t===void 0){ro("InterleavedBufferAttribute.clone(): Cloning an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return new De(new this.array.constructor(e),this.itemSize,this.normalized)}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.clone(t)),new i(t.interleavedBuffers[this.data.uuid],this.itemSize,this.offset,this.normalized)}toJSON(t){if(t===void 0){ro("InterleavedBufferAttribute.toJSON(): Serializing an interleaved buffer attribute will de-interleave buffer data.");let e=[];for(let n=0;n<this.count;n++){let s=n*this.data.stride+this.offset;for(let r=0;r<this.itemSize;r++)e.push(this.data.array[s+r])}return{itemSize:this.itemSize,type:this.array.constructor.name,array:e,normalized:this.normalized}}else return t.interleavedBuffers===void 0&&(t.interleavedBuffers={}),t.interleavedBuffers[this.data.uuid]===void 0&&(t.interleavedBuffers[this.data.uuid]=this.data.toJSON(t)),{isInterleavedBufferAttribute:!0,itemSize:this.itemSize,data:this.data.uuid,offset:this.offset,normalized:this.normalized}}_denormalize(t){let e=this._normalizationScale;return e!==void 0?Math.max(t/e,-1):pu(t,this.data.array)}_normalize(t){let e=this._normalizationScale;return e!==void 0?Math.round(t*e):mu(t,this.data.array)}},Eh=new I,E0=new I,T0=new Ot,Jn=class{constructor(t=new I(1,0,0),e=0){this.isPlane=!0,this.normal=t,this.constant=e}set(t,e){return this.normal.copy(t),this.constant=e,this}setComponents(t,e,n,s){return this.normal.set(t,e,n),this.constant=s,this}setFromNormalAndCoplanarPoint(t,e){return this.normal.copy(t),this.constant=-e.dot(this.normal),this}setFromCoplanarPoints(t,e,n){let s=Eh.subVectors(n,e).cross(E0.subVectors(t,e)).normalize();return this.setFromNormalAndCoplanarPoint(s,t),this}copy(t){return this.normal.copy(t.normal),this.constant=t.constant,this}normalize(){let t=1/this.normal.length();return this.normal.multiplyScalar(t),this.constant*=t,this}negate(){return this.constant*=-1,this.normal.negate(),this}distanceToPoint(t){return this.normal.dot(t)+this.constant}distanceToSphere(t){return this.distanceToPoint(t.center)-t.radius}projectPoint(t,e){return e.copy(t).addScaledVector(this.normal,-this.distanceToPoint(t))}intersectLine(t,e,n=!0){let s=t.delta(Eh),r=this.normal.dot(s);if(r===0)return this.distanceToPoint(t.start)===0?e.copy(t.start):null;let o=-(t.start.dot(this.normal)+this.constant)/r;return n===!0&&(o<0||o>1)?null:e.copy(t.start).addScaledVector(s,o)}intersectsLine(t){let e=this.distanceToPoint(t.start),n=this.distanceToPoint(t.end);return e<0&&n>0||n<0&&e>0}intersectsBox(t){return t.intersectsPlane(this)}intersectsSphere(t){return t.intersectsPlane(this)}coplanarPoint(t){return t.copy(this.normal).multiplyScalar(-this.constant)}applyMatrix4(t,e){let n=e||T0.getNormalMatrix(t),s=this.coplanarPoint(Eh).applyMatrix4(t),r=this.normal.applyMatrix3(n).normalize();return this.constant=-s.dot(r),this}translate(t){return this.constant-=t.dot(this.normal),this}equals(t){return t.normal.equals(this.normal)&&t.constant===this.constant}clone(){return new this.constructor().copy(this)}toJSON(){return{normal:this.normal.toArray(),constant:this.constant}}fromJSON(t){return this.normal.fromArray(t.normal),this.constant=t.constant,this}},R0=0,li=class extends ci{constructor(){super(),this.isMaterial=!0,Object.defineProperty(this,"id",{value:R0++}),this.uuid=os(),this.name="",this.type="Material",this.blending=yr,this.side=ss,this.vertexColors=!1,this.opacity=1,this.transparent=!1,this.alphaHash=!1,this.blendSrc=qh,this.blendDst=Xh,this.blendEquation=Ds,this.blendSrcAlpha=null,this.blendDstAlpha=null,this.blendEquationAlpha=null,this.blendColor=new zt(0,0,0),this.blendAlpha=0,this.depthFunc=or,this.depthTest=!0,this.depthWrite=!0,this.stencilWriteMask=255,this.stencilFunc=zf,this.stencilRef=0,this.stencilFuncMask=255,this.stencilFail=Ga,this.stencilZFail=Ga,this.stencilZPass=Ga,this.stencilWrite=!1,this.clippingPlanes=null,this.clipIntersection=!1,this.clipShadows=!1,this.shadowSide=null,this.colorWrite=!0,this.precision=null,this.polygonOffset=!1,this.polygonOffsetFactor=0,this.polygonOffsetUnits=0,this.dithering=!1,this.alphaToCoverage=!1,this.premultipliedAlpha=!1,this.forceSinglePass=!1,this.allowOverride=!0,this.visible=!0,this.toneMapped=!0,this.userData={},this.version=0,this._alphaTest=0}get alphaTest(){return this._alphaTest}set alphaTest(t){this._alphaTest>0!=t>0&&this.version++,this._alphaTest=t}onBeforeRender(){}onBeforeCompile(){}customProgramCacheKey(){return this.onBeforeCompile.toString()}setValues(t){if(t!==void 0)for(let e in t){let n=t[e];if(n===void 0){It(`Material: parameter '${e}' has value of undefined.`);continue}let s=this[e];if(s===void 0){It(`Material: '${e}' is not a property of THREE.${this.type}.`);continue}s&&s.isColor?s.set(n):s&&s.isVector2&&n&&n.isVector2||s&&s.isEuler&&n&&n.isEuler||s&&s.isVector3&&n&&n.isVector3?s.copy(n):this[e]=n}}toJSON(t){let e=t===void 0||typeof t=="string";e&&(t={textures:{},images:{}});let n={metadata:{version:4.7,type:"Material",generator:"Material.toJSON"}};n.uuid=this.uuid,n.type=this.type,n.blending=this.blending,n.side=this.side,n.shadowSide=this.shadowSide,n.vertexColors=this.vertexColors,n.opacity=this.opacity,n.transparent=this.transparent,n.blendSrc=this.blendSrc,n.blendDst=this.blendDst,n.blendEquation=this.blendEquation,n.blendSrcAlpha=this.blendSrcAlpha,n.blendDstAlpha=this.blendDstAlpha,n.blendEquationAlpha=this.blendEquationAlpha,n.blendColor=this.blendColor.getHex(),n.blendAlpha=this.blendAlpha,n.depthFunc=this.depthFunc,n.depthTest=this.depthTest,n.depthWrite=this.depthWrite,n.colorWrite=this.colorWrite,n.clipIntersection=this.clipIntersection,n.clipShadows=this.clipShadows,n.stencilWriteMask=this.stencilWriteMask,n.stencilFunc=this.stencilFunc,n.stencilRef=this.stencilRef,n.stencilFuncMask=this.stencilFuncMask,n.stencilFail=this.stencilFail,n.stencilZFail=this.stencilZFail,n.stencilZPass=this.stencilZPass,n.stencilWrite=this.stencilWrite,n.polygonOffset=this.polygonOffset,n.polygonOffsetFactor=this.polygonOffsetFactor,n.polygonOffsetUnits=this.polygonOffsetUnits,n.dithering=this.dithering,n.alphaTest=this.alphaTest,n.alphaHash=this.alphaHash,n.alphaToCoverage=this.alphaToCoverage,n.premultipliedAlpha=this.premultipliedAlpha,n.forceSinglePass=this.forceSinglePass,n.allowOverride=this.allowOverride,n.visible=this.visible,n.toneMapped=this.toneMapped,n.name=this.name,this.color&&this.color.isColor&&(n.color=this.color.getHex()),this.roughness!==void 0&&(n.roughness=this.roughness),this.metalness!==void 0&&(n.metalness=this.metalness),this.sheen!==void 0&&(n.sheen=this.sheen),this.sheenColor&&this.sheenColor.isColor&&(n.sheenColor=this.sheenColor.getHex()),this.sheenRoughness!==void 0&&(n.sheenRoughness=this.sheenRoughness),this.emissive&&this.emissive.isColor&&(n.emissive=this.emissive.getHex()),this.emissiveIntensity!==void 0&&(n.emissiveIntensity=this.emissiveIntensity),this.specular&&this.specular.isColor&&(n.specular=this.specular.getHex()),this.specularIntensity!==void 0&&(n.specularIntensity=this.specularIntensity),this.specularColor&&this.specularColor.isColor&&(n.specularColor=this.specularColor.getHex()),this.shininess!==void 0&&(n.shininess=this.shininess),this.clearcoat!==void 0&&(n.clearcoat=this.clearcoat),this.clearcoatRoughness!==void 0&&(n.clearcoatRoughness=this.clearcoatRoughness),this.diffuseRoughness!==void 0&&(n.diffuseRoughness=this.diffuseRoughness),this.diffuseRoughnessMap&&this.diffuseRoughnessMap.isTexture&&(n.diffuseRoughnessMap=this.diffuseRoughnessMap.toJSON(t).uuid),this.clearcoatMap&&this.clearcoatMap.isTexture&&(n.clearcoatMap=this.clearcoatMap.toJSON(t).uuid),this.clearcoatRoughnessMap&&this.clearcoatRoughnessMap.isTexture&&(n.clearcoatRoughnessMap=this.clearcoatRoughnessMap.toJSON(t).uuid),this.clearcoatNormalMap&&this.clearcoatNormalMap.isTexture&&(n.clearcoatNormalMap=this.clearcoatNormalMap.toJSON(t).uuid,n.clearcoatNormalScale=this.clearcoatNormalScale.toArray()),this.sheenColorMap&&this.sheenColorMap.isTexture&&(n.sheenColorMap=this.sheenColorMap.toJSON(t).uuid),this.sheenRoughnessMap&&this.sheenRoughnessMap.isTexture&&(n.sheenRoughnessMap=this.sheenRoughnessMap.toJSON(t).uuid),this.dispersion!==void 0&&(n.dispersion=this.dispersion),this.retroreflectivity!==void 0&&(n.retroreflectivity=this.retroreflectivity),this.iridescence!==void 0&&(n.iridescence=this.iridescence),this.iridescenceIOR!==void 0&&(n.iridescenceIOR=this.iridescenceIOR),this.iridescenceThicknessMinimum!==void 0&&(n.iridescenceThicknessMinimum=this.iridescenceThicknessMinimum),this.iridescenceThicknessMaximum!==void 0&&(n.iridescenceThicknessMaximum=this.iridescenceThicknessMaximum),this.iridescenceMap&&this.iridescenceMap.isTexture&&(n.iridescenceMap=this.iridescenceMap.toJSON(t).uuid),this.iridescenceThicknessMap&&this.iridescenceThicknessMap.isTexture&&(n.iridescenceThicknessMap=this.iridescenceThicknessMap.toJSON(t).uuid),this.anisotropy!==void 0&&(n.anisotropy=this.anisotropy),this.anisotropyRotation!==void 0&&(n.anisotropyRotation=this.anisotropyRotation),this.anisotropyMap&&this.anisotropyMap.isTexture&&(n.anisotropyMap=this.anisotropyMap.toJSON(t).uuid),this.map&&this.map.isTexture&&(n.map=this.map.toJSON(t).uuid),this.matcap&&this.matcap.isTexture&&(n.matcap=this.matcap.toJSON(t).uuid),this.alphaMap&&this.alphaMap.isTexture&&(n.alphaMap=this.alphaMap.toJSON(t).uuid),this.lightMap&&this.lightMap.isTexture&&(n.lightMap=this.lightMap.toJSON(t).uuid,n.lightMapIntensity=this.lightMapIntensity),this.aoMap&&this.aoMap.isTexture&&(n.aoMap=this.aoMap.toJSON(t).uuid,n.aoMapIntensity=this.aoMapIntensity),this.bumpMap&&this.bumpMap.isTexture&&(n.bumpMap=this.bumpMap.toJSON(t).uuid,n.bumpScale=this.bumpScale),this.normalMap&&this.normalMap.isTexture&&(n.normalMap=this.normalMap.toJSON(t).uuid,n.normalMapType=this.normalMapType,n.normalScale=this.normalScale.toArray()),this.displacementMap&&this.displacementMap.isTexture&&(n.displacementMap=this.displacementMap.toJSON(t).uuid,n.displacementScale=this.displacementScale,n.displacementBias=this.displacementBias),this.roughnessMap&&this.roughnessMap.isTexture&&(n.roughnessMap=this.roughnessMap.toJSON(t).uuid),this.metalnessMap&&this.metalnessMap.isTexture&&(n.metalnessMap=this.metalnessMap.toJSON(t).uuid),this.emissiveMap&&this.emissiveMap.isTexture&&(n.emissiveMap=this.emissiveMap.toJSON(t).uuid),this.specularMap&&this.specularMap.isTexture&&(n.specularMap=this.specularMap.toJSON(t).uuid),this.specularIntensityMap&&this.specularIntensityMap.isTexture&&(n.specularIntensityMap=this.specularIntensityMap.toJSON(t).uuid),this.specularColorMap&&this.specularColorMap.isTexture&&(n.specularColorMap=this.specularColorMap.toJSON(t).uuid),this.envMap&&this.envMap.isTexture&&(n.envMap=this.envMap.toJSON(t).uuid,this.combine!==void 0&&(n.combine=this.combine)),this.envMapRotation!==void 0&&(n.envMapRotation=this.envMapRotation.toArray()),this.envMapIntensity!==void 0&&(n.envMapIntensity=this.envMapIntensity),this.reflectivity!==void 0&&(n.reflectivity=this.reflectivity),this.refractionRatio!==void 0&&(n.refractionRatio=this.refractionRatio),this.gradientMap&&this.gradientMap.isTexture&&(n.gradientMap=this.gradientMap.toJSON(t).uuid),this.transmission!==void 0&&(n.transmission=this.transmission),this.transmissionMap&&this.transmissionMap.isTexture&&(n.transmissionMap=this.transmissionMap.toJSON(t).uuid),this.thickness!==void 0&&(n.thickness=this.thickness),this.thicknessMap&&this.thicknessMap.isTexture&&(n.thicknessMap=this.thicknessMap.toJSON(t).uuid),this.attenuationDistance!==void 0&&(n.attenuationDistance=this.attenuationDistance),this.attenuationColor!==void 0&&(n.attenuationColor=this.attenuationColor.getHex()),this.size!==void 0&&(n.size=this.size),this.sizeAttenuation!==void 0&&(n.sizeAttenuation=this.sizeAttenuation),Array.isArray(this.clippingPlanes)&&this.clippingPlanes.length>0&&(n.clippingPlanes=this.clippingPlanes.map(r=>r.toJSON())),this.rotation!==void 0&&(n.rotation=this.rotation),this.depthPacking!==void 0&&(n.depthPacking=this.depthPacking),this.linewidth!==void 0&&(n.linewidth=this.linewidth),this.linecap!==void 0&&(n.linecap=this.linecap),this.linejoin!==void 0&&(n.linejoin=this.linejoin),this.dashSize!==void 0&&(n.dashSize=this.dashSize),this.gapSize!==void 0&&(n.gapSize=this.gapSize),this.scale!==void 0&&(n.scale=this.scale),this.wireframe!==void 0&&(n.wireframe=this.wireframe),this.wireframeLinewidth!==void 0&&(n.wireframeLinewidth=this.wireframeLinewidth),this.wireframeLinecap!==void 0&&(n.wireframeLinecap=this.wireframeLinecap),this.wireframeLinejoin!==void 0&&(n.wireframeLinejoin=this.wireframeLinejoin),this.flatShading!==void 0&&(n.flatShading=this.flatShading),this.fog!==void 0&&(n.fog=this.fog),Object.keys(this.userData).length>0&&(n.userData=this.userData);function s(r){let o=[];for(let a in r){let c=r[a];delete c.metadata,o.push(c)}return o}if(e){let r=s(t.textures),o=s(t.images);r.length>0&&(n.textures=r),o.length>0&&(n.images=o)}return n}fromJSON(t,e){if(t.uuid!==void 0&&(this.uuid=t.uuid),t.name!==void 0&&(this.name=t.name),t.color!==void 0&&this.color!==void 0&&this.color.setHex(t.color),t.roughness!==void 0&&(this.roughness=t.roughness),t.metalness!==void 0&&(this.metalness=t.metalness),t.sheen!==void 0&&(this.sheen=t.sheen),t.sheenColor!==void 0&&(this.sheenColor=new zt().setHex(t.sheenColor)),t.sheenRoughness!==void 0&&(this.sheenRoughness=t.sheenRoughness),t.emissive!==void 0&&this.emissive!==void 0&&this.emissive.setHex(t.emissive),t.specular!==void 0&&this.specular!==void 0&&this.specular.setHex(t.specular),t.specularIntensity!==void 0&&(this.specularIntensity=t.specularIntensity),t.specularColor!==void 0&&this.specularColor!==void 0&&this.specularColor.setHex(t.specularColor),t.shininess!==void 0&&(this.shininess=t.shininess),t.clearcoat!==void 0&&(this.clearcoat=t.clearcoat),t.clearcoatRoughness!==void 0&&(this.clearcoatRoughness=t.clearcoatRoughness),t.diffuseRoughness!==void 0&&(this.diffuseRoughness=t.diffuseRoughness),t.dispersion!==void 0&&(this.dispersion=t.dispersion),t.retroreflectivity!==void 0&&(this.retroreflectivity=t.retroreflectivity),t.iridescence!==void 0&&(this.iridescence=t.iridescence),t.iridescenceIOR!==void 0&&(this.iridescenceIOR=t.iridescenceIOR),t.iridescenceThicknessMinimum!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessMinimum),t.iridescenceThicknessMaximum!==void 0&&(this.iridescenceThicknessMaximum=t.iridescenceThicknessMaximum),t.iridescenceThicknessRange!==void 0&&(this.iridescenceThicknessMinimum=t.iridescenceThicknessRange[0],this.iridescenceThicknessMaximum=t.iridescenceThicknessRange[1]),t.transmission!==void 0&&(this.transmission=t.transmission),t.thickness!==void 0&&(this.thickness=t.thickness),t.attenuationDistance!==void 0&&(this.attenuationDistance=t.attenuationDistance),t.attenuationColor!==void 0&&this.attenuationColor!==void 0&&this.attenuationColor.setHex(t.attenuationColor),t.anisotropy!==void 0&&(this.anisotropy=t.anisotropy),t.anisotropyRotation!==void 0&&(this.anisotropyRotation=t.anisotropyRotation),t.fog!==void 0&&(this.fog=t.fog),t.flatShading!==void 0&&(this.flatShading=t.flatShading),t.blending!==void 0&&(this.blending=t.blending),t.combine!==void 0&&(this.combine=t.combine),t.side!==void 0&&(this.side=t.side),t.shadowSide!==void 0&&(this.shadowSide=t.shadowSide),t.opacity!==void 0&&(this.opacity=t.opacity),t.transparent!==void 0&&(this.transparent=t.transparent),t.alphaTest!==void 0&&(this.alphaTest=t.alphaTest),t.alphaHash!==void 0&&(this.alphaHash=t.alphaHash),t.depthFunc!==void 0&&(this.depthFunc=t.depthFunc),t.depthTest!==void 0&&(this.depthTest=t.depthTest),t.depthWrite!==void 0&&(this.depthWrite=t.depthWrite),t.colorWrite!==void 0&&(this.colorWrite=t.colorWrite),t.clippingPlanes!==void 0&&(this.clippingPlanes=t.clippingPlanes.map(n=>new Jn().fromJSON(n))),t.clipIntersection!==void 0&&(this.clipIntersection=t.clipIntersection),t.clipShadows!==void 0&&(this.clipShadows=t.clipShadows),t.depthPacking!==void 0&&(this.depthPacking=t.depthPacking),t.blendSrc!==void 0&&(this.blendSrc=t.blendSrc),t.blendDst!==void 0&&(this.blendDst=t.blendDst),t.blendEquation!==void 0&&(this.blendEquation=t.blendEquation),t.blendSrcAlpha!==void 0&&(this.blendSrcAlpha=t.blendSrcAlpha),t.blendDstAlpha!==void 0&&(this.blendDstAlpha=t.blendDstAlpha),t.blendEquationAlpha!==void 0&&(this.blendEquationAlpha=t.blendEquationAlpha),t.blendColor!==void 0&&this.blendColor!==void 0&&this.blendColor.setHex(t.blendColor),t.blendAlpha!==void 0&&(this.blendAlpha=t.blendAlpha),t.stencilWriteMask!==void 0&&(this.stencilWriteMask=t.stencilWriteMask),t.stencilFunc!==void 0&&(this.stencilFunc=t.stencilFunc),t.stencilRef!==void 0&&(this.stencilRef=t.stencilRef),t.stencilFuncMask!==void 0&&(this.stencilFuncMask=t.stencilFuncMask),t.stencilFail!==void 0&&(this.stencilFail=t.stencilFail),t.stencilZFail!==void 0&&(this.stencilZFail=t.stencilZFail),t.stencilZPass!==void 0&&(this.stencilZPass=t.stencilZPass),t.stencilWrite!==void 0&&(this.stencilWrite=t.stencilWrite),t.wireframe!==void 0&&(this.wireframe=t.wireframe),t.wireframeLinewidth!==void 0&&(this.wireframeLinewidth=t.wireframeLinewidth),t.wireframeLinecap!==void 0&&(this.wireframeLinecap=t.wireframeLinecap),t.wireframeLinejoin!==void 0&&(this.wireframeLinejoin=t.wireframeLinejoin),t.rotation!==void 0&&(this.rotation=t.rotation),t.linewidth!==void 0&&(this.linewidth=t.linewidth),t.linecap!==void 0&&(this.linecap=t.linecap),t.linejoin!==void 0&&(this.linejoin=t.linejoin),t.dashSize!==void 0&&(this.dashSize=t.dashSize),t.gapSize!==void 0&&(this.gapSize=t.gapSize),t.scale!==void 0&&(this.scale=t.scale),t.polygonOffset!==void 0&&(this.polygonOffset=t.polygonOffset),t.polygonOffsetFactor!==void 0&&(this.polygonOffsetFactor=t.polygonOffsetFactor),t.polygonOffsetUnits!==void 0&&(this.polygonOffsetUnits=t.polygonOffsetUnits),t.dithering!==void 0&&(this.dithering=t.dithering),t.alphaToCoverage!==void 0&&(this.alphaToCoverage=t.alphaToCoverage),t.premultipliedAlpha!==void 0&&(this.premultipliedAlpha=t.premultipliedAlpha),t.forceSinglePass!==void 0&&(this.forceSinglePass=t.forceSinglePass),t.allowOverride!==void 0&&(this.allowOverride=t.allowOverride),t.visible!==void 0&&(this.visible=t.visible),t.toneMapped!==void 0&&(this.toneMapped=t.toneMapped),t.userData!==void 0&&(this.userData=t.userData),t.vertexColors!==void 0&&(typeof t.vertexColors=="number"?this.vertexColors=t.vertexColors>0:this.vertexColors=t.vertexColors),t.size!==void 0&&(this.size=t.size),t.sizeAttenuation!==void 0&&(this.sizeAttenuation=t.sizeAttenuation),t.map!==void 0&&(this.map=e[t.map]||null),t.matcap!==void 0&&(this.matcap=e[t.matcap]||null),t.alphaMap!==void 0&&(this.alphaMap=e[t.alphaMap]||null),t.bumpMap!==void 0&&(this.bumpMap=e[t.bumpMap]||null),t.bumpScale!==void 0&&(this.bumpScale=t.bumpScale),t.normalMap!==void 0&&(this.normalMap=e[t.normalMap]||null),t.normalMapType!==void 0&&(this.normalMapType=t.normalMapType),t.normalScale!==void 0){let n=t.normalScale;Array.isArray(n)===!1&&(n=[n,n]),this.normalScale=new Wt().fromArray(n)}return t.displacementMap!==void 0&&(this.displacementMap=e[t.displacementMap]||null),t.displacementScale!==void 0&&(this.displacementScale=t.displacementScale),t.displacementBias!==void 0&&(this.displacementBias=t.displacementBias),t.roughnessMap!==void 0&&(this.roughnessMap=e[t.roughnessMap]||null),t.metalnessMap!==void 0&&(this.metalnessMap=e[t.metalnessMap]||null),t.emissiveMap!==void 0&&(this.emissiveMap=e[t.emissiveMap]||null),t.emissiveIntensity!==void 0&&(this.emissiveIntensity=t.emissiveIntensity),t.specularMap!==void 0&&(this.specularMap=e[t.specularMap]||null),t.specularIntensityMap!==void 0&&(this.specularIntensityMap=e[t.specularIntensityMap]||null),t.specularColorMap!==void 0&&(this.specularColorMap=e[t.specularColorMap]||null),t.envMap!==void 0&&(this.envMap=e[t.envMap]||null),t.envMapRotation!==void 0&&this.envMapRotation.fromArray(t.envMapRotation),t.envMapIntensity!==void 0&&(this.envMapIntensity=t.envMapIntensity),t.reflectivity!==void 0&&(this.reflectivity=t.reflectivity),t.refractionRatio!==void 0&&(this.refractionRatio=t.refractionRatio),t.lightMap!==void 0&&(this.lightMap=e[t.lightMap]||null),t.lightMapIntensity!==void 0&&(this.lightMapIntensity=t.lightMapIntensity),t.aoMap!==void 0&&(this.aoMap=e[t.aoMap]||null),t.aoMapIntensity!==void 0&&(this.aoMapIntensity=t.aoMapIntensity),t.gradientMap!==void 0&&(this.gradientMap=e[t.gradientMap]||null),t.clearcoatMap!==void 0&&(this.clearcoatMap=e[t.clearcoatMap]||null),t.clearcoatRoughnessMap!==void 0&&(this.clearcoatRoughnessMap=e[t.clearcoatRoughnessMap]||null),t.clearcoatNormalMap!==void 0&&(this.clearcoatNormalMap=e[t.clearcoatNormalMap]||null),t.clearcoatNormalScale!==void 0&&(this.clearcoatNormalScale=new Wt().fromArray(t.clearcoatNormalScale)),t.diffuseRoughnessMap!==void 0&&(this.diffuseRoughnessMap=e[t.diffuseRoughnessMap]||null),t.iridescenceMap!==void 0&&(this.iridescenceMap=e[t.iridescenceMap]||null),t.iridescenceThicknessMap!==void 0&&(this.iridescenceThicknessMap=e[t.iridescenceThicknessMap]||null),t.transmissionMap!==void 0&&(this.transmissionMap=e[t.transmissionMap]||null),t.thicknessMap!==void 0&&(this.thicknessMap=e[t.thicknessMap]||null),t.anisotropyMap!==void 0&&(this.anisotropyMap=e[t.anisotropyMap]||null),t.sheenColorMap!==void 0&&(this.sheenColorMap=e[t.sheenColorMap]||null),t.sheenRoughnessMap!==void 0&&(this.sheenRoughnessMap=e[t.sheenRoughnessMap]||null),this}clone(){return new this.constructor().copy(this)}copy(t){this.name=t.name,this.blending=t.blending,this.side=t.side,this.vertexColors=t.vertexColors,this.opacity=t.opacity,this.transparent=t.transparent,this.blendSrc=t.blendSrc,this.blendDst=t.blendDst,this.blendEquation=t.blendEquation,this.blendSrcAlpha=t.blendSrcAlpha,this.blendDstAlpha=t.blendDstAlpha,this.blendEquationAlpha=t.blendEquationAlpha,this.blendColor.copy(t.blendColor),this.blendAlpha=t.blendAlpha,this.depthFunc=t.depthFunc,this.depthTest=t.depthTest,this.depthWrite=t.depthWrite,this.stencilWriteMask=t.stencilWriteMask,this.stencilFunc=t.stencilFunc,this.stencilRef=t.stencilRef,this.stencilFuncMask=t.stencilFuncMask,this.stencilFail=t.stencilFail,this.stencilZFail=t.stencilZFail,this.stencilZPass=t.stencilZPass,this.stencilWrite=t.stencilWrite;let e=t.clippingPlanes,n=null;if(e!==null){let s=e.length;n=new Array(s);for(let r=0;r!==s;++r)n[r]=e[r].clone()}return this.clippingPlanes=n,this.clipIntersection=t.clipIntersection,this.clipShadows=t.clipShadows,this.shadowSide=t.shadowSide,this.colorWrite=t.colorWrite,this.precision=t.precision,this.polygonOffset=t.polygonOffset,this.polygonOffsetFactor=t.polygonOffsetFactor,this.polygonOffsetUnits=t.polygonOffsetUnits,this.dithering=t.dithering,this.alphaTest=t.alphaTest,this.alphaHash=t.alphaHash,this.alphaToCoverage=t.alphaToCoverage,this.premultipliedAlpha=t.premultipliedAlpha,this.forceSinglePass=t.forceSinglePass,this.allowOverride=t.allowOverride,this.visible=t.visible,this.toneMapped=t.toneMapped,this.userData=JSON.parse(JSON.stringify(t.userData)),this}dispose(){this.dispatchEvent({type:"dispose"})}set needsUpdate(t){t===!0&&this.version++}};var Ei=new I,Th=new I,_a=new I,ya=new I,dr=class{constructor(t=new I,e=new I(0,0,-1)){this.origin=t,this.direction=e}set(t,e){return this.origin.copy(t),this.direction.copy(e),this}copy(t){return this.origin.copy(t.origin),this.direction.copy(t.direction),this}at(t,e){return e.copy(this.origin).addScaledVector(this.direction,t)}lookAt(t){return this.direction.copy(t).sub(this.origin).normalize(),this}recast(t){return this.origin.copy(this.at(t,Ei)),this}closestPointToPoint(t,e){e.subVectors(t,this.origin);let n=e.dot(this.direction);return n<0?e.copy(this.origin):e.copy(this.origin).addScaledVector(this.direction,n)}distanceToPoint(t){return Math.sqrt(this.distanceSqToPoint(t))}distanceSqToPoint(t){let e=Ei.subVectors(t,this.origin).dot(this.direction);return e<0?this.origin.distanceToSquared(t):(Ei.copy(this.origin).addScaledVector(this.direction,e),Ei.distanceToSquared(t))}distanceSqToSegment(t,e,n,s){Th.copy(t).add(e).multiplyScalar(.5),_a.copy(e).sub(t).normalize(),ya.copy(this.origin).sub(Th);let r=t.distanceTo(e)*.5,o=-this.direction.dot(_a),a=ya.dot(this.direction),c=-ya.dot(_a),l=ya.lengthSq(),h=Math.abs(1-o*o),u,d,f,p;if(h>0)if(u=o*c-a,d=o*a-c,p=r*h,u>=0)if(d>=-p)if(d<=p){let x=1/h;u*=x,d*=x,f=u*(u+o*d+2*a)+d*(o*u+d+2*c)+l}else d=r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d=-r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;else d<=-p?(u=Math.max(0,-(-o*r+a)),d=u>0?-r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l):d<=p?(u=0,d=Math.min(Math.max(-r,-c),r),f=d*(d+2*c)+l):(u=Math.max(0,-(o*r+a)),d=u>0?r:Math.min(Math.max(-r,-c),r),f=-u*u+d*(d+2*c)+l);else d=o>0?-r:r,u=Math.max(0,-(o*d+a)),f=-u*u+d*(d+2*c)+l;return n&&n.copy(this.origin).addScaledVector(this.direction,u),s&&s.copy(Th).addScaledVector(_a,d),f}intersectSphere(t,e){if(t.radius<0)return null;Ei.subVectors(t.center,this.origin);let n=Ei.dot(this.direction),s=Ei.dot(Ei)-n*n,r=t.radius*t.radius;if(s>r)return null;let o=Math.sqrt(r-s),a=n-o,c=n+o;return c<0?null:a<0?this.at(c,e):this.at(a,e)}intersectsSphere(t){return t.radius<0?!1:this.distanceSqToPoint(t.center)<=t.radius*t.radius}distanceToPlane(t){let e=t.normal.dot(this.direction);if(e===0)return t.distanceToPoint(this.origin)===0?0:null;let n=-(this.origin.dot(t.normal)+t.constant)/e;return n>=0?n:null}intersectPlane(t,e){let n=this.distanceToPlane(t);return n===null?null:this.at(n,e)}intersectsPlane(t){let e=t.distanceToPoint(this.origin);return e===0||t.normal.dot(this.direction)*e<0}intersectBox(t,e){let n,s,r,o,a,c,l=1/this.direction.x,h=1/this.direction.y,u=1/this.direction.z,d=this.origin;return l>=0?(n=(t.min.x-d.x)*l,s=(t.max.x-d.x)*l):(n=(t.max.x-d.x)*l,s=(t.min.x-d.x)*l),h>=0?(r=(t.min.y-d.y)*h,o=(t.max.y-d.y)*h):(r=(t.max.y-d.y)*h,o=(t.min.y-d.y)*h),n>o||r>s||((r>n||isNaN(n))&&(n=r),(o<s||isNaN(s))&&(s=o),u>=0?(a=(t.min.z-d.z)*u,c=(t.max.z-d.z)*u):(a=(t.max.z-d.z)*u,c=(t.min.z-d.z)*u),n>c||a>s)||((a>n||n!==n)&&(n=a),(c<s||s!==s)&&(s=c),s<0)?null:this.at(n>=0?n:s,e)}intersectsBox(t){return this.intersectBox(t,Ei)!==null}intersectTriangle(t,e,n,s,r){let o=this.origin,a=this.direction,c=a.x,l=a.y,h=a.z,u=t.x-o.x,d=t.y-o.y,f=t.z-o.z,p=e.x-o.x,x=e.y-o.y,m=e.z-o.z,g=n.x-o.x,y=n.y-o.y,S=n.z-o.z,v=Math.abs(c),A=Math.abs(l),w=Math.abs(h),_,M,C,T,L,N,F,P,B,G,H,j;if(v>=A&&v>=w?(C=c,N=u,B=p,j=g,c>=0?(_=l,M=h,T=d,L=f,F=x,P=m,G=y,H=S):(_=h,M=l,T=f,L=d,F=m,P=x,G=S,H=y)):A>=w?(C=l,N=d,B=x,j=y,l>=0?(_=h,M=c,T=f,L=u,F=m,P=p,G=S,H=g):(_=c,M=h,T=u,L=f,F=p,P=m,G=g,H=S)):(C=h,N=f,B=m,j=S,h>=0?(_=c,M=l,T=u,L=d,F=p,P=x,G=g,H=y):(_=l,M=c,T=d,L=u,F=x,P=p,G=y,H=g)),C===0)return null;let W=_/C,Y=M/C,tt=1/C,gt=T-W*N,wt=L-Y*N,X=F-W*B,rt=P-Y*B,xt=G-W*j,At=H-Y*j,pt=xt*rt-At*X,Dt=gt*At-wt*xt,fe=X*wt-rt*gt;if(s){if(pt<0||Dt<0||fe<0)return null}else if((pt<0||Dt<0||fe<0)&&(pt>0||Dt>0||fe>0))return null;let Rt=pt+Dt+fe;if(Rt===0)return null;let Yt=tt*(pt*N+Dt*B+fe*j);return(Rt>0?Yt<0:Yt>0)?null:this.at(Yt/Rt,r)}applyMatrix4(t){return this.origin.applyMatrix4(t),this.direction.transformDirection(t),this}equals(t){return t.origin.equals(this.origin)&&t.direction.equals(this.direction)}clone(){return new this.constructor().copy(this)}},hn=class extends li{constructor(t){super(),this.isMeshBasicMaterial=!0,this.type="MeshBasicMaterial",this.color=new zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pi,this.combine=vc,this.reflectivity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.fog=t.fog,this}},qd=new te,Cs=new dr,va=new xn,Xd=new I,Ma=new I,Sa=new I,ba=new I,Rh=new I,wa=new I,$d=new I,Aa=new I,ee=class extends $e{constructor(t=new Ee,e=new hn){super(),this.isMesh=!0,this.type="Mesh",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.count=1,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}getVertexPosition(t,e){let n=this.geometry,s=n.attributes.position,r=n.morphAttributes.position,o=n.morphTargetsRelative;e.fromBufferAttribute(s,t);let a=this.morphTargetInfluences;if(r&&a){wa.set(0,0,0);for(let c=0,l=r.length;c<l;c++){let h=a[c],u=r[c];h!==0&&(Rh.fromBufferAttribute(u,t),o?wa.addScaledVector(Rh,h):wa.addScaledVector(Rh.sub(e),h))}e.add(wa)}return e}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.material,r=this.matrixWorld;s!==void 0&&(n.boundingSphere===null&&n.computeBoundingSphere(),va.copy(n.boundingSphere),va.applyMatrix4(r),Cs.copy(t.ray).recast(t.near),!(va.containsPoint(Cs.origin)===!1&&(Cs.intersectSphere(va,Xd)===null||Cs.origin.distanceToSquared(Xd)>(t.far-t.near)**2))&&(qd.copy(r).invert(),Cs.copy(t.ray).applyMatrix4(qd),!(n.boundingBox!==null&&Cs.intersectsBox(n.boundingBox)===!1)&&this._computeIntersections(t,e,Cs)))}_computeIntersections(t,e,n){let s,r=this.geometry,o=this.material,a=r.index,c=r.attributes.position,l=r.attributes.uv,h=r.attributes.uv1,u=r.attributes.normal,d=r.groups,f=r.drawRange;if(a!==null)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],y=Math.max(m.start,f.start),S=Math.min(a.count,Math.min(m.start+m.count,f.start+f.count));for(let v=y,A=S;v<A;v+=3){let w=a.getX(v),_=a.getX(v+1),M=a.getX(v+2);s=Ea(this,g,t,n,l,h,u,w,_,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(a.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let y=a.getX(m),S=a.getX(m+1),v=a.getX(m+2);s=Ea(this,o,t,n,l,h,u,y,S,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}else if(c!==void 0)if(Array.isArray(o))for(let p=0,x=d.length;p<x;p++){let m=d[p],g=o[m.materialIndex],y=Math.max(m.start,f.start),S=Math.min(c.count,Math.min(m.start+m.count,f.start+f.count));for(let v=y,A=S;v<A;v+=3){let w=v,_=v+1,M=v+2;s=Ea(this,g,t,n,l,h,u,w,_,M),s&&(s.faceIndex=Math.floor(v/3),s.face.materialIndex=m.materialIndex,e.push(s))}}else{let p=Math.max(0,f.start),x=Math.min(c.count,f.start+f.count);for(let m=p,g=x;m<g;m+=3){let y=m,S=m+1,v=m+2;s=Ea(this,o,t,n,l,h,u,y,S,v),s&&(s.faceIndex=Math.floor(m/3),e.push(s))}}}};function C0(i,t,e,n,s,r,o,a){let c;if(t.side===un?c=n.intersectTriangle(o,r,s,!0,a):c=n.intersectTriangle(s,r,o,t.side===ss,a),c===null)return null;Aa.copy(a),Aa.applyMatrix4(i.matrixWorld);let l=e.ray.origin.distanceTo(Aa);return l<e.near||l>e.far?null:{distance:l,point:Aa.clone(),object:i}}function Ea(i,t,e,n,s,r,o,a,c,l){i.getVertexPosition(a,Ma),i.getVertexPosition(c,Sa),i.getVertexPosition(l,ba);let h=C0(i,t,e,n,Ma,Sa,ba,$d);if(h){let u=new I;Ti.getBarycoord($d,Ma,Sa,ba,u),s&&(h.uv=Ti.getInterpolatedAttribute(s,a,c,l,u,new Wt)),r&&(h.uv1=Ti.getInterpolatedAttribute(r,a,c,l,u,new Wt)),o&&(h.normal=Ti.getInterpolatedAttribute(o,a,c,l,u,new I),h.normal.dot(n.direction)>0&&h.normal.multiplyScalar(-1));let d={a,b:c,c:l,normal:new I,materialIndex:0};Ti.getNormal(Ma,Sa,ba,d.normal),h.face=d,h.barycoord=u}return h}var Ii=class extends gn{constructor(t=null,e=1,n=1,s,r,o,a,c,l=He,h=He,u,d){super(null,o,a,c,l,h,s,r,u,d),this.isDataTexture=!0,this.image={data:t,width:e,height:n},this.generateMipmaps=!1,this.flipY=!1,this.unpackAlignment=1}};var fr=class extends De{constructor(t,e,n,s=1){super(t,e,n),this.isInstancedBufferAttribute=!0,this.meshPerAttribute=s}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}toJSON(){let t=super.toJSON();return t.meshPerAttribute=this.meshPerAttribute,t.isInstancedBufferAttribute=!0,t}},js=new te,Yd=new te,Ta=[],Zd=new ln,P0=new te,Jr=new ee,Kr=new xn,fo=class extends ee{constructor(t,e,n){super(t,e),this.isInstancedMesh=!0,this.instanceMatrix=new fr(new Float32Array(n*16),16),this.instanceColor=null,this.morphTexture=null,this.count=n,this.boundingBox=null,this.boundingSphere=null;for(let s=0;s<n;s++)this.setMatrixAt(s,P0)}computeBoundingBox(){let t=this.geometry,e=this.count;this.boundingBox===null&&(this.boundingBox=new ln),t.boundingBox===null&&t.computeBoundingBox(),this.boundingBox.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,js),Zd.copy(t.boundingBox).applyMatrix4(js),this.boundingBox.union(Zd)}computeBoundingSphere(){let t=this.geometry,e=this.count;this.boundingSphere===null&&(this.boundingSphere=new xn),t.boundingSphere===null&&t.computeBoundingSphere(),this.boundingSphere.makeEmpty();for(let n=0;n<e;n++)this.getMatrixAt(n,js),Kr.copy(t.boundingSphere).applyMatrix4(js),this.boundingSphere.union(Kr)}copy(t,e){return super.copy(t,e),this.instanceMatrix.copy(t.instanceMatrix),this.morphTexture=t.morphTexture!==null?t.morphTexture.clone():null,this.instanceColor=t.instanceColor!==null?t.instanceColor.clone():null,this.count=t.count,this.boundingBox=t.boundingBox!==null?t.boundingBox.clone():null,this.boundingSphere=t.boundingSphere!==null?t.boundingSphere.clone():null,this}getColorAt(t,e){return this.instanceColor===null?e.setRGB(1,1,1):e.fromArray(this.instanceColor.array,t*3)}getMatrixAt(t,e){return e.fromArray(this.instanceMatrix.array,t*16)}getMorphAt(t,e){let n=e.morphTargetInfluences,s=this.morphTexture.source.data.data,r=n.length+1,o=t*r+1;for(let a=0;a<n.length;a++)n[a]=s[o+a]}raycast(t,e){let n=this.matrixWorld,s=this.count;if(Jr.geometry=this.geometry,Jr.material=this.material,Jr.material!==void 0&&(this.boundingSphere===null&&this.computeBoundingSphere(),Kr.copy(this.boundingSphere),Kr.applyMatrix4(n),t.ray.intersectsSphere(Kr)!==!1))for(let r=0;r<s;r++){this.getMatrixAt(r,js),Yd.multiplyMatrices(n,js),Jr.matrixWorld=Yd,Jr.raycast(t,Ta);for(let o=0,a=Ta.length;o<a;o++){let c=Ta[o];c.instanceId=r,c.object=this,e.push(c)}Ta.length=0}}setColorAt(t,e){return this.instanceColor===null&&(this.instanceColor=new fr(new Float32Array(this.instanceMatrix.count*3).fill(1),3)),e.toArray(this.instanceColor.array,t*3),this}setMatrixAt(t,e){return e.toArray(this.instanceMatrix.array,t*16),this}setMorphAt(t,e){let n=e.morphTargetInfluences,s=n.length+1;this.morphTexture===null&&(this.morphTexture=new Ii(new Float32Array(s*this.count),s,this.count,Tc,Gn));let r=this.morphTexture.source.data.data,o=0;for(let l=0;l<n.length;l++)o+=n[l];let a=this.geometry.morphTargetsRelative?1:1-o,c=s*t;return r[c]=a,r.set(n,c+1),this}updateMorphTargets(){}dispose(){super.dispose(),this.instanceMatrix.dispose(),this.instanceColor!==null&&this.instanceColor.dispose(),this.morphTexture!==null&&(this.morphTexture.dispose(),this.morphTexture=null)}},Ps=new xn,I0=new Wt(.5,.5),Ra=new I,Ki=class{constructor(t=new Jn,e=new Jn,n=new Jn,s=new Jn,r=new Jn,o=new Jn){this.planes=[t,e,n,s,r,o]}set(t,e,n,s,r,o){let a=this.planes;return a[0].copy(t),a[1].copy(e),a[2].copy(n),a[3].copy(s),a[4].copy(r),a[5].copy(o),this}copy(t){let e=this.planes;for(let n=0;n<6;n++)e[n].copy(t.planes[n]);return this}setFromProjectionMatrix(t,e=Bn,n=!1){let s=this.planes,r=t.elements,o=r[0],a=r[1],c=r[2],l=r[3],h=r[4],u=r[5],d=r[6],f=r[7],p=r[8],x=r[9],m=r[10],g=r[11],y=r[12],S=r[13],v=r[14],A=r[15];if(s[0].setComponents(l-o,f-h,g-p,A-y).normalize(),s[1].setComponents(l+o,f+h,g+p,A+y).normalize(),s[2].setComponents(l+a,f+u,g+x,A+S).normalize(),s[3].setComponents(l-a,f-u,g-x,A-S).normalize(),n)s[4].setComponents(c,d,m,v).normalize(),s[5].setComponents(l-c,f-d,g-m,A-v).normalize();else if(s[4].setComponents(l-c,f-d,g-m,A-v).normalize(),e===Bn)s[5].setComponents(l+c,f+d,g+m,A+v).normalize();else if(e===ar)s[5].setComponents(c,d,m,v).normalize();else throw new Error("THREE.Frustum.setFromProjectionMatrix(): Invalid coordinate system: "+e);return this}intersectsObject(t){if(t.boundingSphere!==void 0)t.boundingSphere===null&&t.computeBoundingSphere(),Ps.copy(t.boundingSphere).applyMatrix4(t.matrixWorld);else{let e=t.geometry;e.boundingSphere===null&&e.computeBoundingSphere(),Ps.copy(e.boundingSphere).applyMatrix4(t.matrixWorld)}return this.intersectsSphere(Ps)}intersectsSprite(t){Ps.center.set(0,0,0);let e=I0.distanceTo(t.center);return Ps.radius=.7071067811865476+e,Ps.applyMatrix4(t.matrixWorld),this.intersectsSphere(Ps)}intersectsSphere(t){let e=this.planes,n=t.center,s=-t.radius;for(let r=0;r<6;r++)if(e[r].distanceToPoint(n)<s)return!1;return!0}intersectsBox(t){let e=this.planes;for(let n=0;n<6;n++){let s=e[n];if(Ra.x=s.normal.x>0?t.max.x:t.min.x,Ra.y=s.normal.y>0?t.max.y:t.min.y,Ra.z=s.normal.z>0?t.max.z:t.min.z,s.distanceToPoint(Ra)<0)return!1}return!0}containsPoint(t){let e=this.planes;for(let n=0;n<6;n++)if(e[n].distanceToPoint(t)<0)return!1;return!0}clone(){return new this.constructor().copy(this)}},Jd=new te,ec=class i{constructor(){this.coordinateSystem=Bn,this._frustums=[],this._count=0}setFromArrayCamera(t){let e=t.cameras,n=this._frustums;for(let s=0;s<e.length;s++){let r=e[s];Jd.multiplyMatrices(r.projectionMatrix,r.matrixWorldInverse),n[s]===void 0&&(n[s]=new Ki),n[s].setFromProjectionMatrix(Jd,r.coordinateSystem,r.reversedDepth)}return this._count=e.length,this}getFrustum(t){return this._frustums[t]}intersectsObject(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsObject(t))return!0;return!1}intersectsSprite(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSprite(t))return!0;return!1}intersectsSphere(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsSphere(t))return!0;return!1}intersectsBox(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].intersectsBox(t))return!0;return!1}containsPoint(t){let e=this._frustums;for(let n=0;n<this._count;n++)if(e[n].containsPoint(t))return!0;return!1}copy(t){this.coordinateSystem=t.coordinateSystem;let e=this._frustums,n=t._frustums;for(let s=0;s<t._count;s++)e[s]===void 0&&(e[s]=new Ki),e[s].copy(n[s]);return this._count=t._count,this}clone(){return new i().copy(this)}};var ji=class extends li{constructor(t){super(),this.isLineBasicMaterial=!0,this.type="LineBasicMaterial",this.color=new zt(16777215),this.map=null,this.linewidth=1,this.linecap="round",this.linejoin="round",this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.linewidth=t.linewidth,this.linecap=t.linecap,this.linejoin=t.linejoin,this.fog=t.fog,this}},nc=new I,ic=new I,Kd=new te,jr=new dr,Ca=new xn,Ch=new I,jd=new I,pr=class extends $e{constructor(t=new Ee,e=new ji){super(),this.isLine=!0,this.type="Line",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[0];for(let s=1,r=e.count;s<r;s++)nc.fromBufferAttribute(e,s-1),ic.fromBufferAttribute(e,s),n[s]=n[s-1],n[s]+=nc.distanceTo(ic);t.setAttribute("lineDistance",new re(n,1))}else It("Line.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Line.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ca.copy(n.boundingSphere),Ca.applyMatrix4(s),Ca.radius+=r,t.ray.intersectsSphere(Ca)===!1)return;Kd.copy(s).invert(),jr.copy(t.ray).applyMatrix4(Kd);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=this.isLineSegments?2:1,h=n.index,d=n.attributes.position;if(h!==null){let f=Math.max(0,o.start),p=Math.min(h.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=l){let g=h.getX(x),y=h.getX(x+1),S=Pa(this,t,jr,c,g,y,x);S&&e.push(S)}if(this.isLineLoop){let x=h.getX(p-1),m=h.getX(f),g=Pa(this,t,jr,c,x,m,p-1);g&&e.push(g)}}else{let f=Math.max(0,o.start),p=Math.min(d.count,o.start+o.count);for(let x=f,m=p-1;x<m;x+=l){let g=Pa(this,t,jr,c,x,x+1,x);g&&e.push(g)}if(this.isLineLoop){let x=Pa(this,t,jr,c,p-1,f,p-1);x&&e.push(x)}}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function Pa(i,t,e,n,s,r,o){let a=i.geometry.attributes.position;if(nc.fromBufferAttribute(a,s),ic.fromBufferAttribute(a,r),e.distanceSqToSegment(nc,ic,Ch,jd)>n)return;Ch.applyMatrix4(i.matrixWorld);let l=t.ray.origin.distanceTo(Ch);if(!(l<t.near||l>t.far))return{distance:l,point:jd.clone().applyMatrix4(i.matrixWorld),index:o,face:null,faceIndex:null,barycoord:null,object:i}}var Qd=new I,tf=new I,Is=class extends pr{constructor(t,e){super(t,e),this.isLineSegments=!0,this.type="LineSegments"}computeLineDistances(){let t=this.geometry;if(t.index===null){let e=t.attributes.position,n=[];for(let s=0,r=e.count;s<r;s+=2)Qd.fromBufferAttribute(e,s),tf.fromBufferAttribute(e,s+1),n[s]=s===0?0:n[s-1],n[s+1]=n[s]+Qd.distanceTo(tf);t.setAttribute("lineDistance",new re(n,1))}else It("LineSegments.computeLineDistances(): Computation only possible with non-indexed BufferGeometry.");return this}};var mr=class extends li{constructor(t){super(),this.isPointsMaterial=!0,this.type="PointsMaterial",this.color=new zt(16777215),this.map=null,this.alphaMap=null,this.size=1,this.sizeAttenuation=!0,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.alphaMap=t.alphaMap,this.size=t.size,this.sizeAttenuation=t.sizeAttenuation,this.fog=t.fog,this}},ef=new te,Fh=new dr,Ia=new xn,La=new I,po=class extends $e{constructor(t=new Ee,e=new mr){super(),this.isPoints=!0,this.type="Points",this.geometry=t,this.material=e,this.morphTargetDictionary=void 0,this.morphTargetInfluences=void 0,this.updateMorphTargets()}copy(t,e){return super.copy(t,e),t.morphTargetInfluences!==void 0?this.morphTargetInfluences=t.morphTargetInfluences.slice():this.morphTargetInfluences=void 0,t.morphTargetDictionary!==void 0?this.morphTargetDictionary=Object.assign({},t.morphTargetDictionary):this.morphTargetDictionary=void 0,this.material=Array.isArray(t.material)?t.material.slice():t.material,this.geometry=t.geometry,this}intersectsFrustum(t){return t.intersectsObject(this)}raycast(t,e){let n=this.geometry,s=this.matrixWorld,r=t.params.Points.threshold,o=n.drawRange;if(n.boundingSphere===null&&n.computeBoundingSphere(),Ia.copy(n.boundingSphere),Ia.applyMatrix4(s),Ia.radius+=r,t.ray.intersectsSphere(Ia)===!1)return;ef.copy(s).invert(),Fh.copy(t.ray).applyMatrix4(ef);let a=r/((this.scale.x+this.scale.y+this.scale.z)/3),c=a*a,l=n.index,u=n.attributes.position;if(l!==null){let d=Math.max(0,o.start),f=Math.min(l.count,o.start+o.count);for(let p=d,x=f;p<x;p++){let m=l.getX(p);La.fromBufferAttribute(u,m),nf(La,m,c,s,t,e,this)}}else{let d=Math.max(0,o.start),f=Math.min(u.count,o.start+o.count);for(let p=d,x=f;p<x;p++)La.fromBufferAttribute(u,p),nf(La,p,c,s,t,e,this)}}updateMorphTargets(){let e=this.geometry.morphAttributes,n=Object.keys(e);if(n.length>0){let s=e[n[0]];if(s!==void 0){this.morphTargetInfluences=[],this.morphTargetDictionary={};for(let r=0,o=s.length;r<o;r++){let a=s[r].name||String(r);this.morphTargetInfluences.push(0),this.morphTargetDictionary[a]=r}}}}};function nf(i,t,e,n,s,r,o){let a=Fh.distanceSqToPoint(i);if(a<e){let c=new I;Fh.closestPointToPoint(i,c),c.applyMatrix4(n);let l=s.ray.origin.distanceTo(c);if(l<s.near||l>s.far)return;r.push({distance:l,distanceToRay:Math.sqrt(a),point:c,index:t,face:null,faceIndex:null,barycoord:null,object:o})}}var mo=class extends gn{constructor(t=[],e=Us,n,s,r,o,a,c,l,h){super(t,e,n,s,r,o,a,c,l,h),this.isCubeTexture=!0,this.flipY=!1}get images(){return this.image}set images(t){this.image=t}};var Li=class extends gn{constructor(t,e,n=jn,s,r,o,a=He,c=He,l,h=Ci,u=1){if(h!==Ci&&h!==Ui)throw new Error("THREE.DepthTexture: format must be either THREE.DepthFormat or THREE.DepthStencilFormat");let d={width:t,height:e,depth:u};super(d,s,r,o,a,c,h,n,l),this.isDepthTexture=!0,this.flipY=!1,this.generateMipmaps=!1,this.compareFunction=null}copy(t){return super.copy(t),this.source=new hr(Object.assign({},t.image)),this.compareFunction=t.compareFunction,this}toJSON(t){let e=super.toJSON(t);return e.compareFunction=this.compareFunction,e}},go=class extends Li{constructor(t,e=jn,n=Us,s,r,o=He,a=He,c,l=Ci){let h={width:t,height:t,depth:1},u=[h,h,h,h,h,h];super(t,t,e,n,s,r,o,a,c,l),this.image=u,this.isCubeDepthTexture=!0,this.isCubeTexture=!0}get images(){return this.image}set images(t){this.image=t}},xo=class extends gn{constructor(t=null){super(),this.sourceTexture=t,this.isExternalTexture=!0}copy(t){return super.copy(t),this.sourceTexture=t.sourceTexture,this}},Ni=class i extends Ee{constructor(t=1,e=1,n=1,s=1,r=1,o=1){super(),this.type="BoxGeometry",this.parameters={width:t,height:e,depth:n,widthSegments:s,heightSegments:r,depthSegments:o};let a=this;s=Math.floor(s),r=Math.floor(r),o=Math.floor(o);let c=[],l=[],h=[],u=[],d=0,f=0;p("z","y","x",-1,-1,n,e,t,o,r,0),p("z","y","x",1,-1,n,e,-t,o,r,1),p("x","z","y",1,1,t,n,e,s,o,2),p("x","z","y",1,-1,t,n,-e,s,o,3),p("x","y","z",1,-1,t,e,n,s,r,4),p("x","y","z",-1,-1,t,e,-n,s,r,5),this.setIndex(c),this.setAttribute("position",new re(l,3)),this.setAttribute("normal",new re(h,3)),this.setAttribute("uv",new re(u,2));function p(x,m,g,y,S,v,A,w,_,M,C){let T=v/_,L=A/M,N=v/2,F=A/2,P=w/2,B=_+1,G=M+1,H=0,j=0,W=new I;for(let Y=0;Y<G;Y++){let tt=Y*L-F;for(let gt=0;gt<B;gt++){let wt=gt*T-N;W[x]=wt*y,W[m]=tt*S,W[g]=P,l.push(W.x,W.y,W.z),W[x]=0,W[m]=0,W[g]=w>0?1:-1,h.push(W.x,W.y,W.z),u.push(gt/_),u.push(1-Y/M),H+=1}}for(let Y=0;Y<M;Y++)for(let tt=0;tt<_;tt++){let gt=d+tt+B*Y,wt=d+tt+B*(Y+1),X=d+(tt+1)+B*(Y+1),rt=d+(tt+1)+B*Y;c.push(gt,wt,rt),c.push(wt,X,rt),j+=6}a.addGroup(f,j,C),f+=j,d+=H}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.depth,t.widthSegments,t.heightSegments,t.depthSegments)}};var Kn=class i extends Ee{constructor(t=1,e=1,n=1,s=32,r=1,o=!1,a=0,c=Math.PI*2){super(),this.type="CylinderGeometry",this.parameters={radiusTop:t,radiusBottom:e,height:n,radialSegments:s,heightSegments:r,openEnded:o,thetaStart:a,thetaLength:c};let l=this;s=Math.floor(s),r=Math.floor(r);let h=[],u=[],d=[],f=[],p=0,x=[],m=n/2,g=0;y(),o===!1&&(t>0&&S(!0),e>0&&S(!1)),this.setIndex(h),this.setAttribute("position",new re(u,3)),this.setAttribute("normal",new re(d,3)),this.setAttribute("uv",new re(f,2));function y(){let v=new I,A=new I,w=0,_=(e-t)/n;for(let M=0;M<=r;M++){let C=[],T=M/r,L=T*(e-t)+t;for(let N=0;N<=s;N++){let F=N/s,P=F*c+a,B=Math.sin(P),G=Math.cos(P);A.x=L*B,A.y=-T*n+m,A.z=L*G,u.push(A.x,A.y,A.z),v.set(B,_,G).normalize(),d.push(v.x,v.y,v.z),f.push(F,1-T),C.push(p++)}x.push(C)}for(let M=0;M<s;M++)for(let C=0;C<r;C++){let T=x[C][M],L=x[C+1][M],N=x[C+1][M+1],F=x[C][M+1];(t>0||C!==0)&&(h.push(T,L,F),w+=3),(e>0||C!==r-1)&&(h.push(L,N,F),w+=3)}l.addGroup(g,w,0),g+=w}function S(v){let A=p,w=new Wt,_=new I,M=0,C=v===!0?t:e,T=v===!0?1:-1;for(let N=1;N<=s;N++)u.push(0,m*T,0),d.push(0,T,0),f.push(.5,.5),p++;let L=p;for(let N=0;N<=s;N++){let P=N/s*c+a,B=Math.cos(P),G=Math.sin(P);_.x=C*G,_.y=m*T,_.z=C*B,u.push(_.x,_.y,_.z),d.push(0,T,0),w.x=B*.5+.5,w.y=G*.5*T+.5,f.push(w.x,w.y),p++}for(let N=0;N<s;N++){let F=A+N,P=L+N;v===!0?h.push(P,P+1,F):h.push(P+1,P,F),M+=3}l.addGroup(g,M,v===!0?1:2),g+=M}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radiusTop,t.radiusBottom,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},Qi=class i extends Kn{constructor(t=1,e=1,n=32,s=1,r=!1,o=0,a=Math.PI*2){super(0,t,e,n,s,r,o,a),this.type="ConeGeometry",this.parameters={radius:t,height:e,radialSegments:n,heightSegments:s,openEnded:r,thetaStart:o,thetaLength:a}}static fromJSON(t){return new i(t.radius,t.height,t.radialSegments,t.heightSegments,t.openEnded,t.thetaStart,t.thetaLength)}},sc=class i extends Ee{constructor(t=[],e=[],n=1,s=0){super(),this.type="PolyhedronGeometry",this.parameters={vertices:t,indices:e,radius:n,detail:s};let r=[],o=[];a(s),l(n),h(),this.setAttribute("position",new re(r,3)),this.setAttribute("normal",new re(r.slice(),3)),this.setAttribute("uv",new re(o,2)),s===0?this.computeVertexNormals():this.normalizeNormals();function a(y){let S=new I,v=new I,A=new I;for(let w=0;w<e.length;w+=3)f(e[w+0],S),f(e[w+1],v),f(e[w+2],A),c(S,v,A,y)}function c(y,S,v,A){let w=A+1,_=[];for(let M=0;M<=w;M++){_[M]=[];let C=y.clone().lerp(v,M/w),T=S.clone().lerp(v,M/w),L=w-M;for(let N=0;N<=L;N++)N===0&&M===w?_[M][N]=C:_[M][N]=C.clone().lerp(T,N/L)}for(let M=0;M<w;M++)for(let C=0;C<2*(w-M)-1;C++){let T=Math.floor(C/2);C%2===0?(d(_[M][T+1]),d(_[M+1][T]),d(_[M][T])):(d(_[M][T+1]),d(_[M+1][T+1]),d(_[M+1][T]))}}function l(y){let S=new I;for(let v=0;v<r.length;v+=3)S.x=r[v+0],S.y=r[v+1],S.z=r[v+2],S.normalize().multiplyScalar(y),r[v+0]=S.x,r[v+1]=S.y,r[v+2]=S.z}function h(){let y=new I;for(let S=0;S<r.length;S+=3){y.x=r[S+0],y.y=r[S+1],y.z=r[S+2];let v=m(y)/2/Math.PI+.5,A=g(y)/Math.PI+.5;o.push(v,1-A)}p(),u()}function u(){for(let y=0;y<o.length;y+=6){let S=o[y+0],v=o[y+2],A=o[y+4],w=Math.max(S,v,A),_=Math.min(S,v,A);w>.9&&_<.1&&(S<.2&&(o[y+0]+=1),v<.2&&(o[y+2]+=1),A<.2&&(o[y+4]+=1))}}function d(y){r.push(y.x,y.y,y.z)}function f(y,S){let v=y*3;S.x=t[v+0],S.y=t[v+1],S.z=t[v+2]}function p(){let y=new I,S=new I,v=new I,A=new I,w=new Wt,_=new Wt,M=new Wt;for(let C=0,T=0;C<r.length;C+=9,T+=6){y.set(r[C+0],r[C+1],r[C+2]),S.set(r[C+3],r[C+4],r[C+5]),v.set(r[C+6],r[C+7],r[C+8]),w.set(o[T+0],o[T+1]),_.set(o[T+2],o[T+3]),M.set(o[T+4],o[T+5]),A.copy(y).add(S).add(v).divideScalar(3);let L=m(A);x(w,T+0,y,L),x(_,T+2,S,L),x(M,T+4,v,L)}}function x(y,S,v,A){A<0&&y.x===1&&(o[S]=y.x-1),v.x===0&&v.z===0&&(o[S]=A/2/Math.PI+.5)}function m(y){return Math.atan2(y.z,-y.x)}function g(y){return Math.atan2(-y.y,Math.sqrt(y.x*y.x+y.z*y.z))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.vertices,t.indices,t.radius,t.detail)}};var Na=new I,Da=new I,Ph=new I,Ua=new Ti,gr=class extends Ee{constructor(t=null,e=1){if(super(),this.type="EdgesGeometry",this.parameters={geometry:t,thresholdAngle:e},t!==null){let s=Math.pow(10,4),r=Math.cos(sr*e),o=t.getIndex(),a=t.getAttribute("position"),c=o?o.count:a.count,l=[0,0,0],h=["a","b","c"],u=new Array(3),d=new Map,f=[];for(let p=0;p<c;p+=3){o?(l[0]=o.getX(p),l[1]=o.getX(p+1),l[2]=o.getX(p+2)):(l[0]=p,l[1]=p+1,l[2]=p+2);let{a:x,b:m,c:g}=Ua;if(x.fromBufferAttribute(a,l[0]),m.fromBufferAttribute(a,l[1]),g.fromBufferAttribute(a,l[2]),Ua.getNormal(Ph),u[0]=`${Math.round(x.x*s)},${Math.round(x.y*s)},${Math.round(x.z*s)}`,u[1]=`${Math.round(m.x*s)},${Math.round(m.y*s)},${Math.round(m.z*s)}`,u[2]=`${Math.round(g.x*s)},${Math.round(g.y*s)},${Math.round(g.z*s)}`,!(u[0]===u[1]||u[1]===u[2]||u[2]===u[0]))for(let y=0;y<3;y++){let S=(y+1)%3,v=u[y],A=u[S],w=Ua[h[y]],_=Ua[h[S]],M=`${v}_${A}`,C=`${A}_${v}`,T=d.get(C);T?(Ph.dot(T.normal)<=r&&(f.push(w.x,w.y,w.z),f.push(_.x,_.y,_.z)),d.set(C,null)):d.has(M)||d.set(M,{index0:l[y],index1:l[S],normal:Ph.clone()})}}for(let p of d.values())if(p){let{index0:x,index1:m}=p;Na.fromBufferAttribute(a,x),Da.fromBufferAttribute(a,m),f.push(Na.x,Na.y,Na.z),f.push(Da.x,Da.y,Da.z)}this.setAttribute("position",new re(f,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};var _o=class i extends sc{constructor(t=1,e=0){let n=[1,0,0,-1,0,0,0,1,0,0,-1,0,0,0,1,0,0,-1],s=[0,2,4,0,4,3,0,3,5,0,5,2,1,2,5,1,5,3,1,3,4,1,4,2];super(n,s,t,e),this.type="OctahedronGeometry",this.parameters={radius:t,detail:e}}static fromJSON(t){return new i(t.radius,t.detail)}},Ls=class i extends Ee{constructor(t=1,e=1,n=1,s=1){super(),this.type="PlaneGeometry",this.parameters={width:t,height:e,widthSegments:n,heightSegments:s};let r=t/2,o=e/2,a=Math.floor(n),c=Math.floor(s),l=a+1,h=c+1,u=t/a,d=e/c,f=[],p=[],x=[],m=[];for(let g=0;g<h;g++){let y=g*d-o;for(let S=0;S<l;S++){let v=S*u-r;p.push(v,-y,0),x.push(0,0,1),m.push(S/a),m.push(1-g/c)}}for(let g=0;g<c;g++)for(let y=0;y<a;y++){let S=y+l*g,v=y+l*(g+1),A=y+1+l*(g+1),w=y+1+l*g;f.push(S,v,w),f.push(v,A,w)}this.setIndex(f),this.setAttribute("position",new re(p,3)),this.setAttribute("normal",new re(x,3)),this.setAttribute("uv",new re(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.width,t.height,t.widthSegments,t.heightSegments)}};var En=class i extends Ee{constructor(t=1,e=32,n=16,s=0,r=Math.PI*2,o=0,a=Math.PI){super(),this.type="SphereGeometry",this.parameters={radius:t,widthSegments:e,heightSegments:n,phiStart:s,phiLength:r,thetaStart:o,thetaLength:a},e=Math.max(3,Math.floor(e)),n=Math.max(2,Math.floor(n));let c=Math.min(o+a,Math.PI),l=0,h=[],u=new I,d=new I,f=[],p=[],x=[],m=[];for(let g=0;g<=n;g++){let y=[],S=g/n,v=o+S*a,A=t*Math.cos(v),w=Math.sqrt(t*t-A*A),_=0;g===0&&o===0?_=.5/e:g===n&&c===Math.PI&&(_=-.5/e);for(let M=0;M<=e;M++){let C=M/e,T=s+C*r;u.x=-w*Math.cos(T),u.y=A,u.z=w*Math.sin(T),p.push(u.x,u.y,u.z),d.copy(u).normalize(),x.push(d.x,d.y,d.z),m.push(C+_,1-S),y.push(l++)}h.push(y)}for(let g=0;g<n;g++)for(let y=0;y<e;y++){let S=h[g][y+1],v=h[g][y],A=h[g+1][y],w=h[g+1][y+1];(g!==0||o>0)&&f.push(S,v,w),(g!==n-1||c<Math.PI)&&f.push(v,A,w)}this.setIndex(f),this.setAttribute("position",new re(p,3)),this.setAttribute("normal",new re(x,3)),this.setAttribute("uv",new re(m,2))}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}static fromJSON(t){return new i(t.radius,t.widthSegments,t.heightSegments,t.phiStart,t.phiLength,t.thetaStart,t.thetaLength)}};var yo=class extends Ee{constructor(t=null){if(super(),this.type="WireframeGeometry",this.parameters={geometry:t},t!==null){let e=[],n=new Set,s=new I,r=new I;if(t.index!==null){let o=t.attributes.position,a=t.index,c=t.groups;c.length===0&&(c=[{start:0,count:a.count,materialIndex:0}]);for(let l=0,h=c.length;l<h;++l){let u=c[l],d=u.start,f=u.count;for(let p=d,x=d+f;p<x;p+=3)for(let m=0;m<3;m++){let g=a.getX(p+m),y=a.getX(p+(m+1)%3);s.fromBufferAttribute(o,g),r.fromBufferAttribute(o,y),sf(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}}else{let o=t.attributes.position;for(let a=0,c=o.count/3;a<c;a++)for(let l=0;l<3;l++){let h=3*a+l,u=3*a+(l+1)%3;s.fromBufferAttribute(o,h),r.fromBufferAttribute(o,u),sf(s,r,n)===!0&&(e.push(s.x,s.y,s.z),e.push(r.x,r.y,r.z))}}this.setAttribute("position",new re(e,3))}}copy(t){return super.copy(t),this.parameters=Object.assign({},t.parameters),this}};function sf(i,t,e){let n=`${i.x},${i.y},${i.z}-${t.x},${t.y},${t.z}`,s=`${t.x},${t.y},${t.z}-${i.x},${i.y},${i.z}`;return e.has(n)===!0||e.has(s)===!0?!1:(e.add(n),e.add(s),!0)}function Fs(i){let t={};for(let e in i){t[e]={};for(let n in i[e]){let s=i[e][n];if(rf(s))s.isRenderTargetTexture?(It("UniformsUtils: Textures of render targets cannot be cloned via cloneUniforms() or mergeUniforms()."),t[e][n]=null):t[e][n]=s.clone();else if(Array.isArray(s))if(rf(s[0])){let r=[];for(let o=0,a=s.length;o<a;o++)r[o]=s[o].clone();t[e][n]=r}else t[e][n]=s.slice();else t[e][n]=s}}return t}function sn(i){let t={};for(let e=0;e<i.length;e++){let n=Fs(i[e]);for(let s in n)t[s]=n[s]}return t}function rf(i){return i&&(i.isColor||i.isMatrix3||i.isMatrix4||i.isVector2||i.isVector3||i.isVector4||i.isTexture||i.isQuaternion)}function L0(i){let t=[];for(let e=0;e<i.length;e++)t.push(i[e].clone());return t}function gu(i){let t=i.getRenderTarget();return t===null?i.outputColorSpace:t.isXRRenderTarget===!0?t.texture.colorSpace:Kt.workingColorSpace}var Oo={clone:Fs,merge:sn},N0=`void main() {
	gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
}`,D0=`void main() {
	gl_FragColor = vec4( 1.0, 0.0, 0.0, 1.0 );
}`,kn=class extends li{constructor(t){super(),this.isShaderMaterial=!0,this.type="ShaderMaterial",this.defines={},this.uniforms={},this.uniformsGroups=[],this.vertexShader=N0,this.fragmentShader=D0,this.linewidth=1,this.wireframe=!1,this.wireframeLinewidth=1,this.fog=!1,this.lights=!1,this.clipping=!1,this.forceSinglePass=!0,this.extensions={clipCullDistance:!1,multiDraw:!1},this.defaultAttributeValues={color:[1,1,1],uv:[0,0],uv1:[0,0]},this.index0AttributeName=void 0,this.uniformsNeedUpdate=!1,this.glslVersion=null,t!==void 0&&this.setValues(t)}copy(t){return super.copy(t),this.fragmentShader=t.fragmentShader,this.vertexShader=t.vertexShader,this.uniforms=Fs(t.uniforms),this.uniformsGroups=L0(t.uniformsGroups),this.defines=Object.assign({},t.defines),this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.fog=t.fog,this.lights=t.lights,this.clipping=t.clipping,this.extensions=Object.assign({},t.extensions),this.glslVersion=t.glslVersion,this.defaultAttributeValues=Object.assign({},t.defaultAttributeValues),this.index0AttributeName=t.index0AttributeName,this.uniformsNeedUpdate=t.uniformsNeedUpdate,this}toJSON(t){let e=super.toJSON(t);e.glslVersion=this.glslVersion,e.uniforms={};for(let s in this.uniforms){let o=this.uniforms[s].value;o&&o.isTexture?e.uniforms[s]={type:"t",value:o.toJSON(t).uuid}:o&&o.isColor?e.uniforms[s]={type:"c",value:o.getHex()}:o&&o.isVector2?e.uniforms[s]={type:"v2",value:o.toArray()}:o&&o.isVector3?e.uniforms[s]={type:"v3",value:o.toArray()}:o&&o.isVector4?e.uniforms[s]={type:"v4",value:o.toArray()}:o&&o.isMatrix3?e.uniforms[s]={type:"m3",value:o.toArray()}:o&&o.isMatrix4?e.uniforms[s]={type:"m4",value:o.toArray()}:e.uniforms[s]={value:o}}Object.keys(this.defines).length>0&&(e.defines=this.defines),e.vertexShader=this.vertexShader,e.fragmentShader=this.fragmentShader,e.lights=this.lights,e.clipping=this.clipping;let n={};for(let s in this.extensions)this.extensions[s]===!0&&(n[s]=!0);return Object.keys(n).length>0&&(e.extensions=n),e}fromJSON(t,e){if(super.fromJSON(t,e),t.uniforms!==void 0)for(let n in t.uniforms){let s=t.uniforms[n];switch(this.uniforms[n]={},s.type){case"t":this.uniforms[n].value=e[s.value]||null;break;case"c":this.uniforms[n].value=new zt().setHex(s.value);break;case"v2":this.uniforms[n].value=new Wt().fromArray(s.value);break;case"v3":this.uniforms[n].value=new I().fromArray(s.value);break;case"v4":this.uniforms[n].value=new ce().fromArray(s.value);break;case"m3":this.uniforms[n].value=new Ot().fromArray(s.value);break;case"m4":this.uniforms[n].value=new te().fromArray(s.value);break;default:this.uniforms[n].value=s.value}}if(t.defines!==void 0&&(this.defines=t.defines),t.vertexShader!==void 0&&(this.vertexShader=t.vertexShader),t.fragmentShader!==void 0&&(this.fragmentShader=t.fragmentShader),t.glslVersion!==void 0&&(this.glslVersion=t.glslVersion),t.extensions!==void 0)for(let n in t.extensions)this.extensions[n]=t.extensions[n];return t.lights!==void 0&&(this.lights=t.lights),t.clipping!==void 0&&(this.clipping=t.clipping),this}},rc=class extends kn{constructor(t){super(t),this.isRawShaderMaterial=!0,this.type="RawShaderMaterial"}};var Tn=class extends li{constructor(t){super(),this.isMeshLambertMaterial=!0,this.type="MeshLambertMaterial",this.color=new zt(16777215),this.map=null,this.lightMap=null,this.lightMapIntensity=1,this.aoMap=null,this.aoMapIntensity=1,this.emissive=new zt(0),this.emissiveIntensity=1,this.emissiveMap=null,this.bumpMap=null,this.bumpScale=1,this.normalMap=null,this.normalMapType=al,this.normalScale=new Wt(1,1),this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.specularMap=null,this.alphaMap=null,this.envMap=null,this.envMapRotation=new Pi,this.combine=vc,this.reflectivity=1,this.envMapIntensity=1,this.refractionRatio=.98,this.wireframe=!1,this.wireframeLinewidth=1,this.wireframeLinecap="round",this.wireframeLinejoin="round",this.flatShading=!1,this.fog=!0,this.setValues(t)}copy(t){return super.copy(t),this.color.copy(t.color),this.map=t.map,this.lightMap=t.lightMap,this.lightMapIntensity=t.lightMapIntensity,this.aoMap=t.aoMap,this.aoMapIntensity=t.aoMapIntensity,this.emissive.copy(t.emissive),this.emissiveMap=t.emissiveMap,this.emissiveIntensity=t.emissiveIntensity,this.bumpMap=t.bumpMap,this.bumpScale=t.bumpScale,this.normalMap=t.normalMap,this.normalMapType=t.normalMapType,this.normalScale.copy(t.normalScale),this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.specularMap=t.specularMap,this.alphaMap=t.alphaMap,this.envMap=t.envMap,this.envMapRotation.copy(t.envMapRotation),this.combine=t.combine,this.reflectivity=t.reflectivity,this.envMapIntensity=t.envMapIntensity,this.refractionRatio=t.refractionRatio,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this.wireframeLinecap=t.wireframeLinecap,this.wireframeLinejoin=t.wireframeLinejoin,this.flatShading=t.flatShading,this.fog=t.fog,this}},oc=class extends li{constructor(t){super(),this.isMeshDepthMaterial=!0,this.type="MeshDepthMaterial",this.depthPacking=Ff,this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.wireframe=!1,this.wireframeLinewidth=1,this.setValues(t)}copy(t){return super.copy(t),this.depthPacking=t.depthPacking,this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this.wireframe=t.wireframe,this.wireframeLinewidth=t.wireframeLinewidth,this}},ac=class extends li{constructor(t){super(),this.isMeshDistanceMaterial=!0,this.type="MeshDistanceMaterial",this.map=null,this.alphaMap=null,this.displacementMap=null,this.displacementScale=1,this.displacementBias=0,this.setValues(t)}copy(t){return super.copy(t),this.map=t.map,this.alphaMap=t.alphaMap,this.displacementMap=t.displacementMap,this.displacementScale=t.displacementScale,this.displacementBias=t.displacementBias,this}};function Qs(i,t){return!i||i.constructor===t?i:typeof t.BYTES_PER_ELEMENT=="number"?new t(i):Array.prototype.slice.call(i)}function Oa(i){return i!==void 0&&i.inTangents!==void 0&&i.outTangents!==void 0}var ts=class{constructor(t,e,n,s){this.parameterPositions=t,this._cachedIndex=0,this.resultBuffer=s!==void 0?s:new e.constructor(n),this.sampleValues=e,this.valueSize=n,this.settings=null,this.DefaultSettings_={}}evaluate(t){let e=this.parameterPositions,n=this._cachedIndex,s=e[n],r=e[n-1];n:{t:{let o;e:{i:if(!(t<s)){for(let a=n+2;;){if(s===void 0){if(t<r)break i;return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}if(n===a)break;if(r=s,s=e[++n],t<s)break t}o=e.length;break e}if(!(t>=r)){let a=e[1];t<a&&(n=2,r=a);for(let c=n-2;;){if(r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(n===c)break;if(s=r,r=e[--n-1],t>=r)break t}o=n,n=0;break e}break n}for(;n<o;){let a=n+o>>>1;t<e[a]?o=a:n=a+1}if(s=e[n],r=e[n-1],r===void 0)return this._cachedIndex=0,this.copySampleValue_(0);if(s===void 0)return n=e.length,this._cachedIndex=n,this.copySampleValue_(n-1)}this._cachedIndex=n,this.intervalChanged_(n,r,s)}return this.interpolate_(n,r,t,s)}getSettings_(){return this.settings||this.DefaultSettings_}copySampleValue_(t){let e=this.resultBuffer,n=this.sampleValues,s=this.valueSize,r=t*s;for(let o=0;o!==s;++o)e[o]=n[r+o];return e}interpolate_(){throw new Error("THREE.Interpolant: Call to abstract method.")}intervalChanged_(){}},cc=class extends ts{constructor(t,e,n,s){super(t,e,n,s),this._weightPrev=-0,this._offsetPrev=-0,this._weightNext=-0,this._offsetNext=-0,this.DefaultSettings_={endingStart:Dh,endingEnd:Dh}}intervalChanged_(t,e,n){let s=this.parameterPositions,r=t-2,o=t+1,a=s[r],c=s[o];if(a===void 0)switch(this.getSettings_().endingStart){case Uh:r=t,a=2*e-n;break;case Oh:r=s.length-2,a=e+s[r]-s[r+1];break;default:r=t,a=n}if(c===void 0)switch(this.getSettings_().endingEnd){case Uh:o=t,c=2*n-e;break;case Oh:o=1,c=n+s[1]-s[0];break;default:o=t-1,c=e}let l=(n-e)*.5,h=this.valueSize;this._weightPrev=l/(e-a),this._weightNext=l/(c-n),this._offsetPrev=r*h,this._offsetNext=o*h}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this._offsetPrev,u=this._offsetNext,d=this._weightPrev,f=this._weightNext,p=(n-e)/(s-e),x=p*p,m=x*p,g=-d*m+2*d*x-d*p,y=(1+d)*m+(-1.5-2*d)*x+(-.5+d)*p+1,S=(-1-f)*m+(1.5+f)*x+.5*p,v=f*m-f*x;for(let A=0;A!==a;++A)r[A]=g*o[h+A]+y*o[l+A]+S*o[c+A]+v*o[u+A];return r}},lc=class extends ts{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=(n-e)/(s-e),u=1-h;for(let d=0;d!==a;++d)r[d]=o[l+d]*u+o[c+d]*h;return r}},hc=class extends ts{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t){return this.copySampleValue_(t-1)}},uc=class extends ts{interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=t*a,l=c-a,h=this.inTangents,u=this.outTangents;if(!h||!u){let p=(n-e)/(s-e),x=1-p;for(let m=0;m!==a;++m)r[m]=o[l+m]*x+o[c+m]*p;return r}let d=a*2,f=t-1;for(let p=0;p!==a;++p){let x=o[l+p],m=o[c+p],g=f*d+p*2,y=u[g],S=u[g+1],v=t*d+p*2,A=h[v],w=h[v+1],_=O0(n,e,y,A,s);r[p]=Jf(_,x,S,w,m)}return r}};function Jf(i,t,e,n,s){let r=1-i;return r*r*r*t+3*r*r*i*e+3*r*i*i*n+i*i*i*s}function U0(i,t,e,n,s){let r=1-i;return 3*r*r*(e-t)+6*r*i*(n-e)+3*i*i*(s-n)}function O0(i,t,e,n,s){let r=(i-t)/(s-t);for(let o=0;o<8;o++){let a=Jf(r,t,e,n,s)-i;if(Math.abs(a)<1e-10)break;let c=U0(r,t,e,n,s);if(Math.abs(c)<1e-10)break;r=Math.max(0,Math.min(1,r-a/c))}return r}var Rn=class{constructor(t,e,n,s){if(t===void 0)throw new Error("THREE.KeyframeTrack: track name is undefined");if(e===void 0||e.length===0)throw new Error("THREE.KeyframeTrack: no keyframes in track named "+t);this.name=t,this.times=Qs(e,this.TimeBufferType),this.values=Qs(n,this.ValueBufferType),this.setInterpolation(s||this.DefaultInterpolation)}static toJSON(t){let e=t.constructor,n;if(e.toJSON!==this.toJSON)n=e.toJSON(t);else{n={name:t.name,times:Qs(t.times,Array),values:Qs(t.values,Array)};let s=t.getInterpolation();s!==t.DefaultInterpolation&&(n.interpolation=s),Oa(t.settings)&&(n.settings={inTangents:Qs(t.settings.inTangents,Array),outTangents:Qs(t.settings.outTangents,Array)})}return n.type=t.ValueTypeName,n}InterpolantFactoryMethodDiscrete(t){return new hc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodLinear(t){return new lc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodSmooth(t){return new cc(this.times,this.values,this.getValueSize(),t)}InterpolantFactoryMethodBezier(t){let e=new uc(this.times,this.values,this.getValueSize(),t);return this.settings&&(e.inTangents=this.settings.inTangents,e.outTangents=this.settings.outTangents),e}setInterpolation(t){let e;switch(t){case eo:e=this.InterpolantFactoryMethodDiscrete;break;case Ka:e=this.InterpolantFactoryMethodLinear;break;case ka:e=this.InterpolantFactoryMethodSmooth;break;case Nh:e=this.InterpolantFactoryMethodBezier;break}if(e===void 0){let n="unsupported interpolation for "+this.ValueTypeName+" keyframe track named "+this.name;if(this.createInterpolant===void 0)if(t!==this.DefaultInterpolation)this.setInterpolation(this.DefaultInterpolation);else throw new Error(n);return It("KeyframeTrack:",n),this}return this.createInterpolant=e,this}getInterpolation(){switch(this.createInterpolant){case this.InterpolantFactoryMethodDiscrete:return eo;case this.InterpolantFactoryMethodLinear:return Ka;case this.InterpolantFactoryMethodSmooth:return ka;case this.InterpolantFactoryMethodBezier:return Nh}}getValueSize(){return this.values.length/this.times.length}shift(t){if(t!==0){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]+=t;Oa(this.settings)&&(of(this.settings.inTangents,t),of(this.settings.outTangents,t))}return this}scale(t){if(t!==1){let e=this.times;for(let n=0,s=e.length;n!==s;++n)e[n]*=t;Oa(this.settings)&&(af(this.settings.inTangents,t),af(this.settings.outTangents,t))}return this}trim(t,e){let n=this.times,s=n.length,r=0,o=s-1;for(;r!==s&&n[r]<t;)++r;for(;o!==-1&&n[o]>e;)--o;if(++o,r!==0||o!==s){r>=o&&(o=Math.max(o,1),r=o-1);let a=this.getValueSize();this.times=n.slice(r,o),this.values=this.values.slice(r*a,o*a)}return this}validate(){let t=!0,e=this.getValueSize();e-Math.floor(e)!==0&&(Ut("KeyframeTrack: Invalid value size in track.",this),t=!1);let n=this.times,s=this.values,r=n.length;r===0&&(Ut("KeyframeTrack: Track is empty.",this),t=!1);let o=null;for(let a=0;a!==r;a++){let c=n[a];if(typeof c=="number"&&isNaN(c)){Ut("KeyframeTrack: Time is not a valid number.",this,a,c),t=!1;break}if(o!==null&&o>c){Ut("KeyframeTrack: Out of order keys.",this,a,c,o),t=!1;break}o=c}if(s!==void 0&&Kg(s))for(let a=0,c=s.length;a!==c;++a){let l=s[a];if(isNaN(l)){Ut("KeyframeTrack: Value is not a valid number.",this,a,l),t=!1;break}}return t}optimize(){let t=this.times.slice(),e=this.values.slice(),n=this.getValueSize(),s=this.getInterpolation()===ka,r=t.length-1,o=1;for(let a=1;a<r;++a){let c=!1,l=t[a],h=t[a+1];if(l!==h&&(a!==1||l!==t[0]))if(s)c=!0;else{let u=a*n,d=u-n,f=u+n;for(let p=0;p!==n;++p){let x=e[u+p];if(x!==e[d+p]||x!==e[f+p]){c=!0;break}}}if(c){if(a!==o){t[o]=t[a];let u=a*n,d=o*n;for(let f=0;f!==n;++f)e[d+f]=e[u+f]}++o}}if(r>0){t[o]=t[r];for(let a=r*n,c=o*n,l=0;l!==n;++l)e[c+l]=e[a+l];++o}return o!==t.length?(this.times=t.slice(0,o),this.values=e.slice(0,o*n)):(this.times=t,this.values=e),this}clone(){let t=this.times.slice(),e=this.values.slice(),n=this.constructor,s=new n(this.name,t,e);return s.createInterpolant=this.createInterpolant,Oa(this.settings)&&(s.settings={inTangents:this.settings.inTangents.slice(),outTangents:this.settings.outTangents.slice()}),s}};function of(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]+=t}function af(i,t){for(let e=0,n=i.length;e!==n;e+=2)i[e]*=t}Rn.prototype.ValueTypeName="";Rn.prototype.TimeBufferType=Float32Array;Rn.prototype.ValueBufferType=Float32Array;Rn.prototype.DefaultInterpolation=Ka;var es=class extends Rn{constructor(t,e,n){super(t,e,n)}};es.prototype.ValueTypeName="bool";es.prototype.ValueBufferType=Array;es.prototype.DefaultInterpolation=eo;es.prototype.InterpolantFactoryMethodLinear=void 0;es.prototype.InterpolantFactoryMethodSmooth=void 0;var dc=class extends Rn{constructor(t,e,n,s){super(t,e,n,s)}};dc.prototype.ValueTypeName="color";var fc=class extends Rn{constructor(t,e,n,s){super(t,e,n,s)}};fc.prototype.ValueTypeName="number";var pc=class extends ts{constructor(t,e,n,s){super(t,e,n,s)}interpolate_(t,e,n,s){let r=this.resultBuffer,o=this.sampleValues,a=this.valueSize,c=(n-e)/(s-e),l=t*a;for(let h=l+a;l!==h;l+=4)ae.slerpFlat(r,0,o,l-a,o,l,c);return r}},vo=class extends Rn{constructor(t,e,n,s){super(t,e,n,s)}InterpolantFactoryMethodLinear(t){return new pc(this.times,this.values,this.getValueSize(),t)}};vo.prototype.ValueTypeName="quaternion";vo.prototype.InterpolantFactoryMethodSmooth=void 0;var ns=class extends Rn{constructor(t,e,n){super(t,e,n)}};ns.prototype.ValueTypeName="string";ns.prototype.ValueBufferType=Array;ns.prototype.DefaultInterpolation=eo;ns.prototype.InterpolantFactoryMethodLinear=void 0;ns.prototype.InterpolantFactoryMethodSmooth=void 0;var mc=class extends Rn{constructor(t,e,n,s){super(t,e,n,s)}};mc.prototype.ValueTypeName="vector";var gc=class{constructor(t,e,n){let s=this,r=!1,o=0,a=0,c,l=[];this.onStart=void 0,this.onLoad=t,this.onProgress=e,this.onError=n,this._abortController=null,this.itemStart=function(h){a++,r===!1&&s.onStart!==void 0&&s.onStart(h,o,a),r=!0},this.itemEnd=function(h){o++,s.onProgress!==void 0&&s.onProgress(h,o,a),o===a&&(r=!1,s.onLoad!==void 0&&s.onLoad())},this.itemError=function(h){s.onError!==void 0&&s.onError(h)},this.resolveURL=function(h){return h=h.normalize("NFC"),c?c(h):h},this.setURLModifier=function(h){return c=h,this},this.addHandler=function(h,u){return l.push(h,u),this},this.removeHandler=function(h){let u=l.indexOf(h);return u!==-1&&l.splice(u,2),this},this.getHandler=function(h){for(let u=0,d=l.length;u<d;u+=2){let f=l[u],p=l[u+1];if(f.global&&(f.lastIndex=0),f.test(h))return p}return null},this.abort=function(){return this.abortController.abort(),this._abortController=null,this}}get abortController(){return this._abortController||(this._abortController=new AbortController),this._abortController}},Kf=new gc,xc=class{constructor(t){this.manager=t!==void 0?t:Kf,this.crossOrigin="anonymous",this.withCredentials=!1,this.path="",this.resourcePath="",this.requestHeader={},this.priority="auto",this.cache="default",typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}load(){}loadAsync(t,e){let n=this;return new Promise(function(s,r){n.load(t,s,e,r)})}parse(){}setCrossOrigin(t){return this.crossOrigin=t,this}setWithCredentials(t){return this.withCredentials=t,this}setPath(t){return this.path=t,this}setResourcePath(t){return this.resourcePath=t,this}setRequestHeader(t){return this.requestHeader=t,this}setPriority(t){return this.priority=t,this}setCache(t){return this.cache=t,this}abort(){return this}};xc.DEFAULT_MATERIAL_NAME="__DEFAULT";var Mo=class extends $e{static registerNode(t){this.prototype._lightNode=t}constructor(t,e=1){super(),this.isLight=!0,this.type="Light",this.color=new zt(t),this.intensity=e}copy(t,e){return super.copy(t,e),this.color.copy(t.color),this.intensity=t.intensity,this}toJSON(t){let e=super.toJSON(t);return e.object.color=this.color.getHex(),e.object.intensity=this.intensity,e}};var Ih=new te,cf=new I,lf=new I,_c=class{constructor(t){this.camera=t,this.intensity=1,this.bias=0,this.biasNode=null,this.normalBias=0,this.radius=1,this.blurSamples=8,this.mapSize=new Wt(512,512),this.mapType=_n,this.map=null,this.mapPass=null,this.matrix=new te,this.autoUpdate=!0,this.needsUpdate=!1,this._frustum=new Ki,this._frameExtents=new Wt(1,1),this._viewportCount=1,this._viewports=[new ce(0,0,1,1)]}getViewportCount(){return this._viewportCount}getCamera(){return this.camera}getFrustum(){return this._frustum}updateMatrices(t){let e=this.camera;cf.setFromMatrixPosition(t.matrixWorld),e.position.copy(cf),lf.setFromMatrixPosition(t.target.matrixWorld),e.lookAt(lf),e.updateMatrixWorld(),this._updateMatrix(e,this.matrix,this._frustum)}_updateMatrix(t,e,n,s){Ih.multiplyMatrices(t.projectionMatrix,t.matrixWorldInverse),n.setFromProjectionMatrix(Ih,t.coordinateSystem,t.reversedDepth);let r=this._frameExtents,o=s?s.z/r.x:1,a=s?s.w/r.y:1,c=s?s.x/r.x:0,l=s?s.y/r.y:0;t.coordinateSystem===ar||t.reversedDepth?e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,1,0,0,0,0,1):e.set(.5*o,0,0,.5*o+c,0,.5*a,0,.5*a+l,0,0,.5,.5,0,0,0,1),e.multiply(Ih)}getViewport(t){return this._viewports[t]}getFrameExtents(){return this._frameExtents}dispose(){this.map&&this.map.dispose(),this.mapPass&&this.mapPass.dispose()}copy(t){return this.camera=t.camera.clone(),this.intensity=t.intensity,this.bias=t.bias,this.radius=t.radius,this.autoUpdate=t.autoUpdate,this.needsUpdate=t.needsUpdate,this.normalBias=t.normalBias,this.blurSamples=t.blurSamples,this.mapSize.copy(t.mapSize),this.mapType=t.mapType,this.biasNode=t.biasNode,this}clone(){return new this.constructor().copy(this)}toJSON(){let t={};return t.intensity=this.intensity,t.bias=this.bias,t.normalBias=this.normalBias,t.radius=this.radius,t.blurSamples=this.blurSamples,t.mapSize=this.mapSize.toArray(),t.mapType=this.mapType,t.camera=this.camera.toJSON(!1).object,delete t.camera.matrix,t}},Fa=new I,Ba=new ae,oi=new I,So=class extends $e{constructor(){super(),this.isCamera=!0,this.type="Camera",this.matrixWorldInverse=new te,this.projectionMatrix=new te,this.projectionMatrixInverse=new te,this.coordinateSystem=Bn,this._reversedDepth=!1}get reversedDepth(){return this._reversedDepth}copy(t,e){return super.copy(t,e),this.matrixWorldInverse.copy(t.matrixWorldInverse),this.projectionMatrix.copy(t.projectionMatrix),this.projectionMatrixInverse.copy(t.projectionMatrixInverse),this.coordinateSystem=t.coordinateSystem,this}getWorldDirection(t){return super.getWorldDirection(t).negate()}updateMatrixWorld(t){super.updateMatrixWorld(t),this.matrixWorld.decompose(Fa,Ba,oi),oi.x===1&&oi.y===1&&oi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fa,Ba,oi.set(1,1,1)).invert()}updateWorldMatrix(t,e,n=!1){super.updateWorldMatrix(t,e,n),this.matrixWorld.decompose(Fa,Ba,oi),oi.x===1&&oi.y===1&&oi.z===1?this.matrixWorldInverse.copy(this.matrixWorld).invert():this.matrixWorldInverse.compose(Fa,Ba,oi.set(1,1,1)).invert()}clone(){return new this.constructor().copy(this)}},Ji=new I,hf=new Wt,uf=new Wt,cn=class extends So{constructor(t=50,e=1,n=.1,s=2e3){super(),this.isPerspectiveCamera=!0,this.type="PerspectiveCamera",this.fov=t,this.zoom=1,this.near=n,this.far=s,this.focus=10,this.aspect=e,this.view=null,this.filmGauge=35,this.filmOffset=0,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.fov=t.fov,this.zoom=t.zoom,this.near=t.near,this.far=t.far,this.focus=t.focus,this.aspect=t.aspect,this.view=t.view===null?null:Object.assign({},t.view),this.filmGauge=t.filmGauge,this.filmOffset=t.filmOffset,this}setFocalLength(t){let e=.5*this.getFilmHeight()/t;this.fov=lr*2*Math.atan(e),this.updateProjectionMatrix()}getFocalLength(){let t=Math.tan(sr*.5*this.fov);return .5*this.getFilmHeight()/t}getEffectiveFOV(){return lr*2*Math.atan(Math.tan(sr*.5*this.fov)/this.zoom)}getFilmWidth(){return this.filmGauge*Math.min(this.aspect,1)}getFilmHeight(){return this.filmGauge/Math.max(this.aspect,1)}getViewBounds(t,e,n){Ji.set(-1,-1,.5).applyMatrix4(this.projectionMatrixInverse),e.set(Ji.x,Ji.y).multiplyScalar(-t/Ji.z),Ji.set(1,1,.5).applyMatrix4(this.projectionMatrixInverse),n.set(Ji.x,Ji.y).multiplyScalar(-t/Ji.z)}getViewSize(t,e){return this.getViewBounds(t,hf,uf),e.subVectors(uf,hf)}setViewOffset(t,e,n,s,r,o){this.aspect=t/e,this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=this.near,e=t*Math.tan(sr*.5*this.fov)/this.zoom,n=2*e,s=this.aspect*n,r=-.5*s,o=this.view;if(this.view!==null&&this.view.enabled){let c=o.fullWidth,l=o.fullHeight;r+=o.offsetX*s/c,e-=o.offsetY*n/l,s*=o.width/c,n*=o.height/l}let a=this.filmOffset;a!==0&&(r+=t*a/this.getFilmWidth()),this.projectionMatrix.makePerspective(r,r+s,e,e-n,t,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.fov=this.fov,e.object.zoom=this.zoom,e.object.near=this.near,e.object.far=this.far,e.object.focus=this.focus,e.object.aspect=this.aspect,this.view!==null&&(e.object.view=Object.assign({},this.view)),e.object.filmGauge=this.filmGauge,e.object.filmOffset=this.filmOffset,e}};var bo=class extends So{constructor(t=-1,e=1,n=1,s=-1,r=.1,o=2e3){super(),this.isOrthographicCamera=!0,this.type="OrthographicCamera",this.zoom=1,this.view=null,this.left=t,this.right=e,this.top=n,this.bottom=s,this.near=r,this.far=o,this.updateProjectionMatrix()}copy(t,e){return super.copy(t,e),this.left=t.left,this.right=t.right,this.top=t.top,this.bottom=t.bottom,this.near=t.near,this.far=t.far,this.zoom=t.zoom,this.view=t.view===null?null:Object.assign({},t.view),this}setViewOffset(t,e,n,s,r,o){this.view===null&&(this.view={enabled:!0,fullWidth:1,fullHeight:1,offsetX:0,offsetY:0,width:1,height:1}),this.view.enabled=!0,this.view.fullWidth=t,this.view.fullHeight=e,this.view.offsetX=n,this.view.offsetY=s,this.view.width=r,this.view.height=o,this.updateProjectionMatrix()}clearViewOffset(){this.view!==null&&(this.view.enabled=!1),this.updateProjectionMatrix()}updateProjectionMatrix(){let t=(this.right-this.left)/(2*this.zoom),e=(this.top-this.bottom)/(2*this.zoom),n=(this.right+this.left)/2,s=(this.top+this.bottom)/2,r=n-t,o=n+t,a=s+e,c=s-e;if(this.view!==null&&this.view.enabled){let l=(this.right-this.left)/this.view.fullWidth/this.zoom,h=(this.top-this.bottom)/this.view.fullHeight/this.zoom;r+=l*this.view.offsetX,o=r+l*this.view.width,a-=h*this.view.offsetY,c=a-h*this.view.height}this.projectionMatrix.makeOrthographic(r,o,a,c,this.near,this.far,this.coordinateSystem,this.reversedDepth),this.projectionMatrixInverse.copy(this.projectionMatrix).invert()}toJSON(t){let e=super.toJSON(t);return e.object.zoom=this.zoom,e.object.left=this.left,e.object.right=this.right,e.object.top=this.top,e.object.bottom=this.bottom,e.object.near=this.near,e.object.far=this.far,this.view!==null&&(e.object.view=Object.assign({},this.view)),e}},Bh=class extends _c{constructor(){super(new bo(-5,5,5,-5,.5,500)),this.isDirectionalLightShadow=!0}},wo=class extends Mo{constructor(t,e){super(t,e),this.isDirectionalLight=!0,this.type="DirectionalLight",this.position.copy($e.DEFAULT_UP),this.updateMatrix(),this.target=new $e,this.shadow=new Bh}dispose(){super.dispose(),this.shadow.dispose()}copy(t){return super.copy(t),this.target=t.target.clone(),this.shadow=t.shadow.clone(),this}toJSON(t){let e=super.toJSON(t);return e.object.shadow=this.shadow.toJSON(),e.object.target=this.target.uuid,e}},Ao=class extends Mo{constructor(t,e){super(t,e),this.isAmbientLight=!0,this.type="AmbientLight"}};var Eo=class extends Ee{constructor(){super(),this.isInstancedBufferGeometry=!0,this.type="InstancedBufferGeometry",this.instanceCount=1/0}copy(t){return super.copy(t),this.instanceCount=t.instanceCount,this}toJSON(){let t=super.toJSON();return t.instanceCount=this.instanceCount,t.isInstancedBufferGeometry=!0,t}};var tr=-90,er=1,xr=class extends $e{constructor(t,e,n){super(),this.type="CubeCamera",this.renderTarget=n,this.coordinateSystem=null,this.activeMipmapLevel=0;let s=new cn(tr,er,t,e);s.layers=this.layers,this.add(s);let r=new cn(tr,er,t,e);r.layers=this.layers,this.add(r);let o=new cn(tr,er,t,e);o.layers=this.layers,this.add(o);let a=new cn(tr,er,t,e);a.layers=this.layers,this.add(a);let c=new cn(tr,er,t,e);c.layers=this.layers,this.add(c);let l=new cn(tr,er,t,e);l.layers=this.layers,this.add(l)}updateCoordinateSystem(){let t=this.coordinateSystem,e=this.children.concat(),[n,s,r,o,a,c]=e;for(let l of e)this.remove(l);if(t===Bn)n.up.set(0,1,0),n.lookAt(1,0,0),s.up.set(0,1,0),s.lookAt(-1,0,0),r.up.set(0,0,-1),r.lookAt(0,1,0),o.up.set(0,0,1),o.lookAt(0,-1,0),a.up.set(0,1,0),a.lookAt(0,0,1),c.up.set(0,1,0),c.lookAt(0,0,-1);else if(t===ar)n.up.set(0,-1,0),n.lookAt(-1,0,0),s.up.set(0,-1,0),s.lookAt(1,0,0),r.up.set(0,0,1),r.lookAt(0,1,0),o.up.set(0,0,-1),o.lookAt(0,-1,0),a.up.set(0,-1,0),a.lookAt(0,0,1),c.up.set(0,-1,0),c.lookAt(0,0,-1);else throw new Error("THREE.CubeCamera.updateCoordinateSystem(): Invalid coordinate system: "+t);for(let l of e)this.add(l),l.updateMatrixWorld()}update(t,e){this.parent===null&&this.updateMatrixWorld();let{renderTarget:n,activeMipmapLevel:s}=this;this.coordinateSystem!==t.coordinateSystem&&(this.coordinateSystem=t.coordinateSystem,this.updateCoordinateSystem());let[r,o,a,c,l,h]=this.children,u=t.getRenderTarget(),d=t.getActiveCubeFace(),f=t.getActiveMipmapLevel(),p=t.xr.enabled;t.xr.enabled=!1;let x=n.texture.mipmapsAutoUpdate;n.texture.mipmapsAutoUpdate=!1;let m=!1;t.isWebGLRenderer===!0?m=t.state.buffers.depth.getReversed():m=t.reversedDepthBuffer,t.setRenderTarget(n,0,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,r),t.setRenderTarget(n,1,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,o),t.setRenderTarget(n,2,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,a),t.setRenderTarget(n,3,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,c),t.setRenderTarget(n,4,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,l),n.texture.mipmapsAutoUpdate=x,t.setRenderTarget(n,5,s),m&&t.autoClear===!1&&t.clearDepth(),t.render(e,h),t.setRenderTarget(u,d,f),t.xr.enabled=p,n.texture.needsPMREMUpdate=!0}},yc=class extends cn{constructor(t=[]){super(),this.isArrayCamera=!0,this.isMultiViewCamera=!1,this.cameras=t,this.perCameraFrustumCulled=!1}};var xu="\\[\\]\\.:\\/",F0=new RegExp("["+xu+"]","g"),_u="[^"+xu+"]",B0="[^"+xu.replace("\\.","")+"]",z0=/((?:WC+[\/:])*)/.source.replace("WC",_u),k0=/(WCOD+)?/.source.replace("WCOD",B0),G0=/(?:\.(WC+)(?:\[(.+)\])?)?/.source.replace("WC",_u),V0=/\.(WC+)(?:\[(.+)\])?/.source.replace("WC",_u),H0=new RegExp("^"+z0+k0+G0+V0+"$"),W0=["material","materials","bones","map"],zh=class{constructor(t,e,n){let s=n||_e.parseTrackName(e);this._targetGroup=t,this._bindings=t.subscribe_(e,s)}getValue(t,e){this.bind();let n=this._targetGroup.nCachedObjects_,s=this._bindings[n];s!==void 0&&s.getValue(t,e)}setValue(t,e){let n=this._bindings;for(let s=this._targetGroup.nCachedObjects_,r=n.length;s!==r;++s)n[s].setValue(t,e)}bind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].bind()}unbind(){let t=this._bindings;for(let e=this._targetGroup.nCachedObjects_,n=t.length;e!==n;++e)t[e].unbind()}},_e=class i{constructor(t,e,n){this.path=e,this.parsedPath=n||i.parseTrackName(e),this.node=i.findNode(t,this.parsedPath.nodeName),this.rootNode=t,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}static create(t,e,n){return t&&t.isAnimationObjectGroup?new i.Composite(t,e,n):new i(t,e,n)}static sanitizeNodeName(t){return t.replace(/\s/g,"_").replace(F0,"")}static parseTrackName(t){let e=H0.exec(t);if(e===null)throw new Error("THREE.PropertyBinding: Cannot parse trackName: "+t);let n={nodeName:e[2],objectName:e[3],objectIndex:e[4],propertyName:e[5],propertyIndex:e[6]},s=n.nodeName&&n.nodeName.lastIndexOf(".");if(s!==void 0&&s!==-1){let r=n.nodeName.substring(s+1);W0.indexOf(r)!==-1&&(n.nodeName=n.nodeName.substring(0,s),n.objectName=r)}if(n.propertyName===null||n.propertyName.length===0)throw new Error("THREE.PropertyBinding: can not parse propertyName from trackName: "+t);return n}static findNode(t,e){if(e===void 0||e===""||e==="."||e===-1||e===t.name||e===t.uuid)return t;if(t.skeleton){let n=t.skeleton.getBoneByName(e);if(n!==void 0)return n}if(t.children){let n=function(r){for(let o=0;o<r.length;o++){let a=r[o];if(a.name===e||a.uuid===e)return a;let c=n(a.children);if(c)return c}return null},s=n(t.children);if(s)return s}return null}_getValue_unavailable(){}_setValue_unavailable(){}_getValue_direct(t,e){t[e]=this.targetObject[this.propertyName]}_getValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)t[e++]=n[s]}_getValue_arrayElement(t,e){t[e]=this.resolvedProperty[this.propertyIndex]}_getValue_toArray(t,e){this.resolvedProperty.toArray(t,e)}_setValue_direct(t,e){this.targetObject[this.propertyName]=t[e]}_setValue_direct_setNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.needsUpdate=!0}_setValue_direct_setMatrixWorldNeedsUpdate(t,e){this.targetObject[this.propertyName]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_array(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++]}_setValue_array_setNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.needsUpdate=!0}_setValue_array_setMatrixWorldNeedsUpdate(t,e){let n=this.resolvedProperty;for(let s=0,r=n.length;s!==r;++s)n[s]=t[e++];this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_arrayElement(t,e){this.resolvedProperty[this.propertyIndex]=t[e]}_setValue_arrayElement_setNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.needsUpdate=!0}_setValue_arrayElement_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty[this.propertyIndex]=t[e],this.targetObject.matrixWorldNeedsUpdate=!0}_setValue_fromArray(t,e){this.resolvedProperty.fromArray(t,e)}_setValue_fromArray_setNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.needsUpdate=!0}_setValue_fromArray_setMatrixWorldNeedsUpdate(t,e){this.resolvedProperty.fromArray(t,e),this.targetObject.matrixWorldNeedsUpdate=!0}_getValue_unbound(t,e){this.bind(),this.getValue(t,e)}_setValue_unbound(t,e){this.bind(),this.setValue(t,e)}bind(){let t=this.node,e=this.parsedPath,n=e.objectName,s=e.propertyName,r=e.propertyIndex;if(t||(t=i.findNode(this.rootNode,e.nodeName),this.node=t),this.getValue=this._getValue_unavailable,this.setValue=this._setValue_unavailable,!t){It("PropertyBinding: No target node found for track: "+this.path+".");return}if(n){let l=e.objectIndex;switch(n){case"materials":if(!t.material){Ut("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.materials){Ut("PropertyBinding: Can not bind to material.materials as node.material does not have a materials array.",this);return}t=t.material.materials;break;case"bones":if(!t.skeleton){Ut("PropertyBinding: Can not bind to bones as node does not have a skeleton.",this);return}t=t.skeleton.bones;for(let h=0;h<t.length;h++)if(t[h].name===l){l=h;break}break;case"map":if("map"in t){t=t.map;break}if(!t.material){Ut("PropertyBinding: Can not bind to material as node does not have a material.",this);return}if(!t.material.map){Ut("PropertyBinding: Can not bind to material.map as node.material does not have a map.",this);return}t=t.material.map;break;default:if(t[n]===void 0){Ut("PropertyBinding: Can not bind to objectName of node undefined.",this);return}t=t[n]}if(l!==void 0){if(t[l]===void 0){Ut("PropertyBinding: Trying to bind to objectIndex of objectName, but is undefined.",this,t);return}t=t[l]}}let o=t[s];if(o===void 0){let l=e.nodeName;Ut("PropertyBinding: Trying to update property for track: "+l+"."+s+" but it wasn't found.",t);return}let a=this.Versioning.None;this.targetObject=t,t.isMaterial===!0?a=this.Versioning.NeedsUpdate:t.isObject3D===!0&&(a=this.Versioning.MatrixWorldNeedsUpdate);let c=this.BindingType.Direct;if(r!==void 0){if(s==="morphTargetInfluences"){if(!t.geometry){Ut("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.",this);return}if(!t.geometry.morphAttributes){Ut("PropertyBinding: Can not bind to morphTargetInfluences because node does not have a geometry.morphAttributes.",this);return}t.morphTargetDictionary[r]!==void 0&&(r=t.morphTargetDictionary[r])}c=this.BindingType.ArrayElement,this.resolvedProperty=o,this.propertyIndex=r}else o.fromArray!==void 0&&o.toArray!==void 0?(c=this.BindingType.HasFromToArray,this.resolvedProperty=o):Array.isArray(o)?(c=this.BindingType.EntireArray,this.resolvedProperty=o):this.propertyName=s;this.getValue=this.GetterByBindingType[c],this.setValue=this.SetterByBindingTypeAndVersioning[c][a]}unbind(){this.node=null,this.getValue=this._getValue_unbound,this.setValue=this._setValue_unbound}};_e.Composite=zh;_e.prototype.BindingType={Direct:0,EntireArray:1,ArrayElement:2,HasFromToArray:3};_e.prototype.Versioning={None:0,NeedsUpdate:1,MatrixWorldNeedsUpdate:2};_e.prototype.GetterByBindingType=[_e.prototype._getValue_direct,_e.prototype._getValue_array,_e.prototype._getValue_arrayElement,_e.prototype._getValue_toArray];_e.prototype.SetterByBindingTypeAndVersioning=[[_e.prototype._setValue_direct,_e.prototype._setValue_direct_setNeedsUpdate,_e.prototype._setValue_direct_setMatrixWorldNeedsUpdate],[_e.prototype._setValue_array,_e.prototype._setValue_array_setNeedsUpdate,_e.prototype._setValue_array_setMatrixWorldNeedsUpdate],[_e.prototype._setValue_arrayElement,_e.prototype._setValue_arrayElement_setNeedsUpdate,_e.prototype._setValue_arrayElement_setMatrixWorldNeedsUpdate],[_e.prototype._setValue_fromArray,_e.prototype._setValue_fromArray_setNeedsUpdate,_e.prototype._setValue_fromArray_setMatrixWorldNeedsUpdate]];var eE=new Float32Array(1);var is=class extends uo{constructor(t,e,n=1){super(t,e),this.isInstancedInterleavedBuffer=!0,this.meshPerAttribute=n}copy(t){return super.copy(t),this.meshPerAttribute=t.meshPerAttribute,this}clone(t){let e=super.clone(t);return e.meshPerAttribute=this.meshPerAttribute,e}toJSON(t){let e=super.toJSON(t);return e.isInstancedInterleavedBuffer=!0,e.meshPerAttribute=this.meshPerAttribute,e}};var kh=class{static{this.prototype.isMatrix2=!0}constructor(t,e,n,s){this.elements=[1,0,0,1],t!==void 0&&this.set(t,e,n,s)}identity(){return this.set(1,0,0,1),this}fromArray(t,e=0){for(let n=0;n<4;n++)this.elements[n]=t[n+e];return this}set(t,e,n,s){let r=this.elements;return r[0]=t,r[2]=e,r[1]=n,r[3]=s,this}};var df=new I,za=new I,nr=new I,ir=new I,Lh=new I,q0=new I,X0=new I,To=class{constructor(t=new I,e=new I){this.start=t,this.end=e}set(t,e){return this.start.copy(t),this.end.copy(e),this}copy(t){return this.start.copy(t.start),this.end.copy(t.end),this}getCenter(t){return t.addVectors(this.start,this.end).multiplyScalar(.5)}delta(t){return t.subVectors(this.end,this.start)}distanceSq(){return this.start.distanceToSquared(this.end)}distance(){return this.start.distanceTo(this.end)}at(t,e){return this.delta(e).multiplyScalar(t).add(this.start)}closestPointToPointParameter(t,e){df.subVectors(t,this.start),za.subVectors(this.end,this.start);let n=za.dot(za);if(n===0)return 0;let r=za.dot(df)/n;return e&&(r=Gt(r,0,1)),r}closestPointToPoint(t,e,n){let s=this.closestPointToPointParameter(t,e);return this.delta(n).multiplyScalar(s).add(this.start)}distanceSqToLine3(t,e=q0,n=X0){let s=10000000000000001e-32,r,o,a=this.start,c=t.start,l=this.end,h=t.end;nr.subVectors(l,a),ir.subVectors(h,c),Lh.subVectors(a,c);let u=nr.dot(nr),d=ir.dot(ir),f=ir.dot(Lh);if(u<=s&&d<=s)return e.copy(a),n.copy(c),e.distanceToSquared(n);if(u<=s)r=0,o=f/d,o=Gt(o,0,1);else{let p=nr.dot(Lh);if(d<=s)o=0,r=Gt(-p/u,0,1);else{let x=nr.dot(ir),m=u*d-x*x;m!==0?r=Gt((x*f-p*d)/m,0,1):r=0,o=(x*r+f)/d,o<0?(o=0,r=Gt(-p/u,0,1)):o>1&&(o=1,r=Gt((x-p)/u,0,1))}}return e.copy(a).addScaledVector(nr,r),n.copy(c).addScaledVector(ir,o),e.distanceToSquared(n)}applyMatrix4(t){return this.start.applyMatrix4(t),this.end.applyMatrix4(t),this}equals(t){return t.start.equals(this.start)&&t.end.equals(this.end)}clone(){return new this.constructor().copy(this)}};function yu(i,t,e,n){let s=$0(n);switch(e){case ru:return i*t;case Tc:return i*t/s.components*s.byteLength;case Rc:return i*t/s.components*s.byteLength;case rs:return i*t*2/s.components*s.byteLength;case Cc:return i*t*2/s.components*s.byteLength;case ou:return i*t*3/s.components*s.byteLength;case ti:return i*t*4/s.components*s.byteLength;case Pc:return i*t*4/s.components*s.byteLength;case Po:case Io:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Lo:case No:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Lc:case Dc:return Math.max(i,16)*Math.max(t,8)/4;case Ic:case Nc:return Math.max(i,8)*Math.max(t,8)/2;case Uc:case Oc:case Bc:case zc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*8;case Fc:case Do:case kc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Gc:return Math.floor((i+3)/4)*Math.floor((t+3)/4)*16;case Vc:return Math.floor((i+4)/5)*Math.floor((t+3)/4)*16;case Hc:return Math.floor((i+4)/5)*Math.floor((t+4)/5)*16;case Wc:return Math.floor((i+5)/6)*Math.floor((t+4)/5)*16;case qc:return Math.floor((i+5)/6)*Math.floor((t+5)/6)*16;case Xc:return Math.floor((i+7)/8)*Math.floor((t+4)/5)*16;case $c:return Math.floor((i+7)/8)*Math.floor((t+5)/6)*16;case Yc:return Math.floor((i+7)/8)*Math.floor((t+7)/8)*16;case Zc:return Math.floor((i+9)/10)*Math.floor((t+4)/5)*16;case Jc:return Math.floor((i+9)/10)*Math.floor((t+5)/6)*16;case Kc:return Math.floor((i+9)/10)*Math.floor((t+7)/8)*16;case jc:return Math.floor((i+9)/10)*Math.floor((t+9)/10)*16;case Qc:return Math.floor((i+11)/12)*Math.floor((t+9)/10)*16;case tl:return Math.floor((i+11)/12)*Math.floor((t+11)/12)*16;case el:case nl:case il:return Math.ceil(i/4)*Math.ceil(t/4)*16;case sl:case rl:return Math.ceil(i/4)*Math.ceil(t/4)*8;case Uo:case ol:return Math.ceil(i/4)*Math.ceil(t/4)*16}throw new Error(`Unable to determine texture byte length for ${e} format.`)}function $0(i){switch(i){case _n:case eu:return{byteLength:1,components:1};case Mr:case nu:case Qn:return{byteLength:2,components:1};case Ac:case Ec:return{byteLength:2,components:4};case jn:case wc:case Gn:return{byteLength:4,components:1};case iu:case su:return{byteLength:4,components:3}}throw new Error(`THREE.TextureUtils: Unknown texture type ${i}.`)}typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("register",{detail:{revision:"187"}}));typeof window<"u"&&(window.__THREE__?It("WARNING: Multiple instances of Three.js being imported."):window.__THREE__="187");function yp(){let i=null,t=!1,e=null,n=null;function s(r,o){n=i.requestAnimationFrame(s),e(r,o)}return{start:function(){t!==!0&&e!==null&&i!==null&&(n=i.requestAnimationFrame(s),t=!0)},stop:function(){i!==null&&i.cancelAnimationFrame(n),t=!1},setAnimationLoop:function(r){e=r},setContext:function(r){i=r}}}function j0(i){let t=new WeakMap;function e(a,c){let l=a.array,h=a.usage,u=l.byteLength,d=i.createBuffer();i.bindBuffer(c,d),i.bufferData(c,l,h),a.onUploadCallback();let f;if(l instanceof Float32Array)f=i.FLOAT;else if(typeof Float16Array<"u"&&l instanceof Float16Array)f=i.HALF_FLOAT;else if(l instanceof Uint16Array)a.isFloat16BufferAttribute?f=i.HALF_FLOAT:f=i.UNSIGNED_SHORT;else if(l instanceof Int16Array)f=i.SHORT;else if(l instanceof Uint32Array)f=i.UNSIGNED_INT;else if(l instanceof Int32Array)f=i.INT;else if(l instanceof Int8Array)f=i.BYTE;else if(l instanceof Uint8Array)f=i.UNSIGNED_BYTE;else if(l instanceof Uint8ClampedArray)f=i.UNSIGNED_BYTE;else throw new Error("THREE.WebGLAttributes: Unsupported buffer data format: "+l);return{buffer:d,type:f,bytesPerElement:l.BYTES_PER_ELEMENT,version:a.version,size:u}}function n(a,c,l){let h=c.array,u=c.updateRanges;if(i.bindBuffer(l,a),u.length===0)i.bufferSubData(l,0,h);else{u.sort((f,p)=>f.start-p.start);let d=0;for(let f=1;f<u.length;f++){let p=u[d],x=u[f];x.start<=p.start+p.count+1?p.count=Math.max(p.count,x.start+x.count-p.start):(++d,u[d]=x)}u.length=d+1;for(let f=0,p=u.length;f<p;f++){let x=u[f];i.bufferSubData(l,x.start*h.BYTES_PER_ELEMENT,h,x.start,x.count)}c.clearUpdateRanges()}c.onUploadCallback()}function s(a){return a.isInterleavedBufferAttribute&&(a=a.data),t.get(a)}function r(a){a.isInterleavedBufferAttribute&&(a=a.data);let c=t.get(a);c&&(i.deleteBuffer(c.buffer),t.delete(a))}function o(a,c){if(a.isInterleavedBufferAttribute&&(a=a.data),a.isGLBufferAttribute){let h=t.get(a);(!h||h.version<a.version)&&t.set(a,{buffer:a.buffer,type:a.type,bytesPerElement:a.elementSize,version:a.version});return}let l=t.get(a);if(l===void 0)t.set(a,e(a,c));else if(l.version<a.version){if(l.size!==a.array.byteLength)throw new Error("THREE.WebGLAttributes: The size of the buffer attribute's array buffer does not match the original size. Resizing buffer attributes is not supported.");n(l.buffer,a,c),l.version=a.version}}return{get:s,remove:r,update:o}}var Q0=`#ifdef USE_ALPHAHASH
	if ( diffuseColor.a < getAlphaHashThreshold( vPosition ) ) discard;
#endif`,tx=`#ifdef USE_ALPHAHASH
	const float ALPHA_HASH_SCALE = 0.05;
	float hash2D( vec2 value ) {
		return fract( 1.0e4 * sin( 17.0 * value.x + 0.1 * value.y ) * ( 0.1 + abs( sin( 13.0 * value.y + value.x ) ) ) );
	}
	float hash3D( vec3 value ) {
		return hash2D( vec2( hash2D( value.xy ), value.z ) );
	}
	float getAlphaHashThreshold( vec3 position ) {
		float maxDeriv = max(
			length( dFdx( position.xyz ) ),
			length( dFdy( position.xyz ) )
		);
		float pixScale = 1.0 / ( ALPHA_HASH_SCALE * maxDeriv );
		vec2 pixScales = vec2(
			exp2( floor( log2( pixScale ) ) ),
			exp2( ceil( log2( pixScale ) ) )
		);
		vec2 alpha = vec2(
			hash3D( floor( pixScales.x * position.xyz ) ),
			hash3D( floor( pixScales.y * position.xyz ) )
		);
		float lerpFactor = fract( log2( pixScale ) );
		float x = ( 1.0 - lerpFactor ) * alpha.x + lerpFactor * alpha.y;
		float a = min( lerpFactor, 1.0 - lerpFactor );
		vec3 cases = vec3(
			x * x / ( 2.0 * a * ( 1.0 - a ) ),
			( x - 0.5 * a ) / ( 1.0 - a ),
			1.0 - ( ( 1.0 - x ) * ( 1.0 - x ) / ( 2.0 * a * ( 1.0 - a ) ) )
		);
		float threshold = ( x < ( 1.0 - a ) )
			? ( ( x < a ) ? cases.x : cases.y )
			: cases.z;
		return clamp( threshold , 1.0e-6, 1.0 );
	}
#endif`,ex=`#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, vAlphaMapUv ).g;
#endif`,nx=`#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,ix=`#ifdef USE_ALPHATEST
	#ifdef ALPHA_TO_COVERAGE
	diffuseColor.a = smoothstep( alphaTest, alphaTest + fwidth( diffuseColor.a ), diffuseColor.a );
	if ( diffuseColor.a == 0.0 ) discard;
	#else
	if ( diffuseColor.a < alphaTest ) discard;
	#endif
#endif`,sx=`#ifdef USE_ALPHATEST
	uniform float alphaTest;
#endif`,rx=`#ifdef USE_AOMAP
	float ambientOcclusion = ( texture2D( aoMap, vAoMapUv ).r - 1.0 ) * aoMapIntensity + 1.0;
	reflectedLight.indirectDiffuse *= ambientOcclusion;
	#if defined( USE_CLEARCOAT ) 
		clearcoatSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_SHEEN ) 
		sheenSpecularIndirect *= ambientOcclusion;
	#endif
	#if defined( USE_ENVMAP ) && defined( STANDARD )
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		reflectedLight.indirectSpecular *= computeSpecularOcclusion( dotNV, ambientOcclusion, material.roughness );
	#endif
#endif`,ox=`#ifdef USE_AOMAP
	uniform sampler2D aoMap;
	uniform float aoMapIntensity;
#endif`,ax=`#ifdef USE_BATCHING
	#if ! defined( GL_ANGLE_multi_draw )
	#define gl_DrawID _gl_DrawID
	uniform int _gl_DrawID;
	#endif
	uniform highp sampler2D batchingTexture;
	uniform highp usampler2D batchingIdTexture;
	mat4 getBatchingMatrix( const in float i ) {
		int size = textureSize( batchingTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( batchingTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( batchingTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( batchingTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( batchingTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
	float getIndirectIndex( const in int i ) {
		int size = textureSize( batchingIdTexture, 0 ).x;
		int x = i % size;
		int y = i / size;
		return float( texelFetch( batchingIdTexture, ivec2( x, y ), 0 ).r );
	}
#endif
#ifdef USE_BATCHING_COLOR
	uniform sampler2D batchingColorTexture;
	vec4 getBatchingColor( const in float i ) {
		int size = textureSize( batchingColorTexture, 0 ).x;
		int j = int( i );
		int x = j % size;
		int y = j / size;
		return texelFetch( batchingColorTexture, ivec2( x, y ), 0 );
	}
#endif`,cx=`#ifdef USE_BATCHING
	mat4 batchingMatrix = getBatchingMatrix( getIndirectIndex( gl_DrawID ) );
#endif`,lx=`vec3 transformed = vec3( position );
#ifdef USE_ALPHAHASH
	vPosition = vec3( position );
#endif`,hx=`vec3 objectNormal = vec3( normal );
#ifdef USE_TANGENT
	vec3 objectTangent = vec3( tangent.xyz );
#endif`,ux=`float G_BlinnPhong_Implicit( ) {
	return 0.25;
}
float D_BlinnPhong( const in float shininess, const in float dotNH ) {
	return RECIPROCAL_PI * ( shininess * 0.5 + 1.0 ) * pow( dotNH, shininess );
}
vec3 BRDF_BlinnPhong( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 specularColor, const in float shininess ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( specularColor, 1.0, dotVH );
	float G = G_BlinnPhong_Implicit( );
	float D = D_BlinnPhong( shininess, dotNH );
	return F * ( G * D );
} // validated`,dx=`#ifdef USE_IRIDESCENCE
	const mat3 XYZ_TO_REC709 = mat3(
		 3.2404542, -0.9692660,  0.0556434,
		-1.5371385,  1.8760108, -0.2040259,
		-0.4985314,  0.0415560,  1.0572252
	);
	vec3 Fresnel0ToIor( vec3 fresnel0 ) {
		vec3 sqrtF0 = sqrt( fresnel0 );
		return ( vec3( 1.0 ) + sqrtF0 ) / ( vec3( 1.0 ) - sqrtF0 );
	}
	vec3 IorToFresnel0( vec3 transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - vec3( incidentIor ) ) / ( transmittedIor + vec3( incidentIor ) ) );
	}
	float IorToFresnel0( float transmittedIor, float incidentIor ) {
		return pow2( ( transmittedIor - incidentIor ) / ( transmittedIor + incidentIor ));
	}
	vec3 evalSensitivity( float OPD, vec3 shift ) {
		float phase = 2.0 * PI * OPD * 1.0e-9;
		vec3 val = vec3( 5.4856e-13, 4.4201e-13, 5.2481e-13 );
		vec3 pos = vec3( 1.6810e+06, 1.7953e+06, 2.2084e+06 );
		vec3 var = vec3( 4.3278e+09, 9.3046e+09, 6.6121e+09 );
		vec3 xyz = val * sqrt( 2.0 * PI * var ) * cos( pos * phase + shift ) * exp( - pow2( phase ) * var );
		xyz.x += 9.7470e-14 * sqrt( 2.0 * PI * 4.5282e+09 ) * cos( 2.2399e+06 * phase + shift[ 0 ] ) * exp( - 4.5282e+09 * pow2( phase ) );
		xyz /= 1.0685e-7;
		vec3 rgb = XYZ_TO_REC709 * xyz;
		return rgb;
	}
	vec3 evalIridescence( float outsideIOR, float eta2, float cosTheta1, float thinFilmThickness, vec3 baseF0 ) {
		vec3 I;
		float iridescenceIOR = mix( outsideIOR, eta2, smoothstep( 0.0, 0.03, thinFilmThickness ) );
		float sinTheta2Sq = pow2( outsideIOR / iridescenceIOR ) * ( 1.0 - pow2( cosTheta1 ) );
		float cosTheta2Sq = 1.0 - sinTheta2Sq;
		if ( cosTheta2Sq < 0.0 ) {
			return vec3( 1.0 );
		}
		float cosTheta2 = sqrt( cosTheta2Sq );
		float R0 = IorToFresnel0( iridescenceIOR, outsideIOR );
		float R12 = F_Schlick( R0, 1.0, cosTheta1 );
		float T121 = 1.0 - R12;
		float phi12 = 0.0;
		if ( iridescenceIOR < outsideIOR ) phi12 = PI;
		float phi21 = PI - phi12;
		vec3 baseIOR = Fresnel0ToIor( clamp( baseF0, 0.0, 0.9999 ) );		vec3 R1 = IorToFresnel0( baseIOR, iridescenceIOR );
		vec3 R23 = F_Schlick( R1, 1.0, cosTheta2 );
		vec3 phi23 = vec3( 0.0 );
		if ( baseIOR[ 0 ] < iridescenceIOR ) phi23[ 0 ] = PI;
		if ( baseIOR[ 1 ] < iridescenceIOR ) phi23[ 1 ] = PI;
		if ( baseIOR[ 2 ] < iridescenceIOR ) phi23[ 2 ] = PI;
		float OPD = 2.0 * iridescenceIOR * thinFilmThickness * cosTheta2;
		vec3 phi = vec3( phi21 ) + phi23;
		vec3 R123 = clamp( R12 * R23, 1e-5, 0.9999 );
		vec3 r123 = sqrt( R123 );
		vec3 Rs = pow2( T121 ) * R23 / ( vec3( 1.0 ) - R123 );
		vec3 C0 = R12 + Rs;
		I = C0;
		vec3 Cm = Rs - T121;
		for ( int m = 1; m <= 2; ++ m ) {
			Cm *= r123;
			vec3 Sm = 2.0 * evalSensitivity( float( m ) * OPD, float( m ) * phi );
			I += Cm * Sm;
		}
		return max( I, vec3( 0.0 ) );
	}
#endif`,fx=`#ifdef USE_BUMPMAP
	uniform sampler2D bumpMap;
	uniform float bumpScale;
	vec2 dHdxy_fwd() {
		vec2 dSTdx = dFdx( vBumpMapUv );
		vec2 dSTdy = dFdy( vBumpMapUv );
		float Hll = bumpScale * texture2D( bumpMap, vBumpMapUv ).x;
		float dBx = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdx ).x - Hll;
		float dBy = bumpScale * texture2D( bumpMap, vBumpMapUv + dSTdy ).x - Hll;
		return vec2( dBx, dBy );
	}
	vec3 perturbNormalArb( vec3 surf_pos, vec3 surf_norm, vec2 dHdxy, float faceDirection ) {
		vec3 vSigmaX = normalize( dFdx( surf_pos.xyz ) );
		vec3 vSigmaY = normalize( dFdy( surf_pos.xyz ) );
		vec3 vN = surf_norm;
		vec3 R1 = cross( vSigmaY, vN );
		vec3 R2 = cross( vN, vSigmaX );
		float fDet = dot( vSigmaX, R1 ) * faceDirection;
		vec3 vGrad = sign( fDet ) * ( dHdxy.x * R1 + dHdxy.y * R2 );
		return normalize( abs( fDet ) * surf_norm - vGrad );
	}
#endif`,px=`#if NUM_CLIPPING_PLANES > 0
	vec4 plane;
	#ifdef ALPHA_TO_COVERAGE
		float distanceToPlane, distanceGradient;
		float clipOpacity = 1.0;
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
			distanceGradient = fwidth( distanceToPlane ) / 2.0;
			clipOpacity *= smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			if ( clipOpacity == 0.0 ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			float unionClipOpacity = 1.0;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				distanceToPlane = - dot( vClipPosition, plane.xyz ) + plane.w;
				distanceGradient = fwidth( distanceToPlane ) / 2.0;
				unionClipOpacity *= 1.0 - smoothstep( - distanceGradient, distanceGradient, distanceToPlane );
			}
			#pragma unroll_loop_end
			clipOpacity *= 1.0 - unionClipOpacity;
		#endif
		diffuseColor.a *= clipOpacity;
		if ( diffuseColor.a == 0.0 ) discard;
	#else
		#pragma unroll_loop_start
		for ( int i = 0; i < UNION_CLIPPING_PLANES; i ++ ) {
			plane = clippingPlanes[ i ];
			if ( dot( vClipPosition, plane.xyz ) > plane.w ) discard;
		}
		#pragma unroll_loop_end
		#if UNION_CLIPPING_PLANES < NUM_CLIPPING_PLANES
			bool clipped = true;
			#pragma unroll_loop_start
			for ( int i = UNION_CLIPPING_PLANES; i < NUM_CLIPPING_PLANES; i ++ ) {
				plane = clippingPlanes[ i ];
				clipped = ( dot( vClipPosition, plane.xyz ) > plane.w ) && clipped;
			}
			#pragma unroll_loop_end
			if ( clipped ) discard;
		#endif
	#endif
#endif`,mx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
	uniform vec4 clippingPlanes[ NUM_CLIPPING_PLANES ];
#endif`,gx=`#if NUM_CLIPPING_PLANES > 0
	varying vec3 vClipPosition;
#endif`,xx=`#if NUM_CLIPPING_PLANES > 0
	vClipPosition = - mvPosition.xyz;
#endif`,_x=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	diffuseColor *= vColor;
#endif`,yx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA )
	varying vec4 vColor;
#endif`,vx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	varying vec4 vColor;
#endif`,Mx=`#if defined( USE_COLOR ) || defined( USE_COLOR_ALPHA ) || defined( USE_INSTANCING_COLOR ) || defined( USE_BATCHING_COLOR )
	vColor = vec4( 1.0 );
#endif
#ifdef USE_COLOR_ALPHA
	vColor *= color;
#elif defined( USE_COLOR )
	vColor.rgb *= color;
#endif
#ifdef USE_INSTANCING_COLOR
	vColor.rgb *= instanceColor.rgb;
#endif
#ifdef USE_BATCHING_COLOR
	vColor *= getBatchingColor( getIndirectIndex( gl_DrawID ) );
#endif`,Sx=`#define PI 3.141592653589793
#define PI2 6.283185307179586
#define PI_HALF 1.5707963267948966
#define RECIPROCAL_PI 0.3183098861837907
#define RECIPROCAL_PI2 0.15915494309189535
#define EPSILON 1e-6
#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
#define whiteComplement( a ) ( 1.0 - saturate( a ) )
float pow2( const in float x ) { return x*x; }
vec3 pow2( const in vec3 x ) { return x*x; }
float pow3( const in float x ) { return x*x*x; }
float pow4( const in float x ) { float x2 = x*x; return x2*x2; }
float max3( const in vec3 v ) { return max( max( v.x, v.y ), v.z ); }
float average( const in vec3 v ) { return dot( v, vec3( 0.3333333 ) ); }
highp float rand( const in vec2 uv ) {
	const highp float a = 12.9898, b = 78.233, c = 43758.5453;
	highp float dt = dot( uv.xy, vec2( a,b ) ), sn = mod( dt, PI );
	return fract( sin( sn ) * c );
}
#ifdef HIGH_PRECISION
	float precisionSafeLength( vec3 v ) { return length( v ); }
#else
	float precisionSafeLength( vec3 v ) {
		float maxComponent = max3( abs( v ) );
		return length( v / maxComponent ) * maxComponent;
	}
#endif
struct IncidentLight {
	vec3 color;
	vec3 direction;
	bool visible;
};
struct ReflectedLight {
	vec3 directDiffuse;
	vec3 directSpecular;
	vec3 indirectDiffuse;
	vec3 indirectSpecular;
};
#ifdef USE_ALPHAHASH
	varying vec3 vPosition;
#endif
vec3 transformDirection( in vec3 dir, in mat4 matrix ) {
	return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );
}
#define inverseTransformDirection transformDirectionByInverseViewMatrix
vec3 transformNormalByInverseViewMatrix( in vec3 normal, in mat4 viewMatrix ) {
	return normalize( ( vec4( normal, 0.0 ) * viewMatrix ).xyz );
}
vec3 transformDirectionByInverseViewMatrix( in vec3 dir, in mat4 viewMatrix ) {
	return normalize( ( vec4( dir, 0.0 ) * viewMatrix ).xyz );
}
bool isPerspectiveMatrix( mat4 m ) {
	return m[ 2 ][ 3 ] == - 1.0;
}
vec2 equirectUv( in vec3 dir ) {
	float u = atan( dir.z, dir.x ) * RECIPROCAL_PI2 + 0.5;
	float v = asin( clamp( dir.y, - 1.0, 1.0 ) ) * RECIPROCAL_PI + 0.5;
	return vec2( u, v );
}
vec3 BRDF_Lambert( const in vec3 diffuseColor ) {
	return RECIPROCAL_PI * diffuseColor;
}
vec3 F_Schlick( const in vec3 f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
}
float F_Schlick( const in float f0, const in float f90, const in float dotVH ) {
	float fresnel = exp2( ( - 5.55473 * dotVH - 6.98316 ) * dotVH );
	return f0 * ( 1.0 - fresnel ) + ( f90 * fresnel );
} // validated`,bx=`vec3 transformedNormal = objectNormal;
#ifdef USE_TANGENT
	vec3 transformedTangent = objectTangent;
#endif
#ifdef USE_BATCHING
	mat3 bm = mat3( batchingMatrix );
	transformedNormal /= vec3( dot( bm[ 0 ], bm[ 0 ] ), dot( bm[ 1 ], bm[ 1 ] ), dot( bm[ 2 ], bm[ 2 ] ) );
	transformedNormal = bm * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = bm * transformedTangent;
	#endif
#endif
#ifdef USE_INSTANCING
	mat3 im = mat3( instanceMatrix );
	transformedNormal /= vec3( dot( im[ 0 ], im[ 0 ] ), dot( im[ 1 ], im[ 1 ] ), dot( im[ 2 ], im[ 2 ] ) );
	transformedNormal = im * transformedNormal;
	#ifdef USE_TANGENT
		transformedTangent = im * transformedTangent;
	#endif
#endif
transformedNormal = normalMatrix * transformedNormal;
#ifdef FLIP_SIDED
	transformedNormal = - transformedNormal;
#endif
#ifdef USE_TANGENT
	transformedTangent = ( modelViewMatrix * vec4( transformedTangent, 0.0 ) ).xyz;
#endif`,wx=`#ifdef USE_DISPLACEMENTMAP
	uniform sampler2D displacementMap;
	uniform float displacementScale;
	uniform float displacementBias;
#endif`,Ax=`#ifdef USE_DISPLACEMENTMAP
	transformed += normalize( objectNormal ) * ( texture2D( displacementMap, vDisplacementMapUv ).x * displacementScale + displacementBias );
#endif`,Ex=`#ifdef USE_EMISSIVEMAP
	vec4 emissiveColor = texture2D( emissiveMap, vEmissiveMapUv );
	#ifdef DECODE_VIDEO_TEXTURE_EMISSIVE
		emissiveColor = sRGBTransferEOTF( emissiveColor );
	#endif
	totalEmissiveRadiance *= emissiveColor.rgb;
#endif`,Tx=`#ifdef USE_EMISSIVEMAP
	uniform sampler2D emissiveMap;
#endif`,Rx="gl_FragColor = linearToOutputTexel( gl_FragColor );",Cx=`vec4 LinearTransferOETF( in vec4 value ) {
	return value;
}
vec4 sRGBTransferEOTF( in vec4 value ) {
	return vec4( mix( pow( value.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), value.rgb * 0.0773993808, vec3( lessThanEqual( value.rgb, vec3( 0.04045 ) ) ) ), value.a );
}
vec4 sRGBTransferOETF( in vec4 value ) {
	return vec4( mix( pow( value.rgb, vec3( 0.41666 ) ) * 1.055 - vec3( 0.055 ), value.rgb * 12.92, vec3( lessThanEqual( value.rgb, vec3( 0.0031308 ) ) ) ), value.a );
}`,Px=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vec3 cameraToFrag;
		if ( isOrthographic ) {
			cameraToFrag = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToFrag = normalize( vWorldPosition - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vec3 reflectVec = reflect( cameraToFrag, worldNormal );
		#else
			vec3 reflectVec = refract( cameraToFrag, worldNormal, refractionRatio );
		#endif
	#else
		vec3 reflectVec = vReflect;
	#endif
	#ifdef ENVMAP_TYPE_CUBE
		vec4 envColor = textureCube( envMap, envMapRotation * reflectVec );
		#ifdef ENVMAP_BLENDING_MULTIPLY
			outgoingLight = mix( outgoingLight, outgoingLight * envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_MIX )
			outgoingLight = mix( outgoingLight, envColor.xyz, specularStrength * reflectivity );
		#elif defined( ENVMAP_BLENDING_ADD )
			outgoingLight += envColor.xyz * specularStrength * reflectivity;
		#endif
	#endif
#endif`,Ix=`#ifdef USE_ENVMAP
	uniform float envMapIntensity;
	uniform mat3 envMapRotation;
	uniform samplerCube envMap;
	#ifdef ENVMAP_TYPE_PMREM
		float roughnessToMip( const in float roughness ) {
			float r = clamp( roughness, 0.0, 1.0 );
			return ENVMAP_MAX_LOD * r * ( 2.0 - r );
		}
	#endif
#endif`,Lx=`#ifdef USE_ENVMAP
	uniform float reflectivity;
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		varying vec3 vWorldPosition;
		uniform float refractionRatio;
	#else
		varying vec3 vReflect;
	#endif
#endif`,Nx=`#ifdef USE_ENVMAP
	#if defined( USE_BUMPMAP ) || defined( USE_NORMALMAP ) || defined( PHONG ) || defined( LAMBERT )
		#define ENV_WORLDPOS
	#endif
	#ifdef ENV_WORLDPOS
		
		varying vec3 vWorldPosition;
	#else
		varying vec3 vReflect;
		uniform float refractionRatio;
	#endif
#endif`,Dx=`#ifdef USE_ENVMAP
	#ifdef ENV_WORLDPOS
		vWorldPosition = worldPosition.xyz;
	#else
		vec3 cameraToVertex;
		if ( isOrthographic ) {
			cameraToVertex = normalize( vec3( - viewMatrix[ 0 ][ 2 ], - viewMatrix[ 1 ][ 2 ], - viewMatrix[ 2 ][ 2 ] ) );
		} else {
			cameraToVertex = normalize( worldPosition.xyz - cameraPosition );
		}
		vec3 worldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
		#ifdef ENVMAP_MODE_REFLECTION
			vReflect = reflect( cameraToVertex, worldNormal );
		#else
			vReflect = refract( cameraToVertex, worldNormal, refractionRatio );
		#endif
	#endif
#endif`,Ux=`#ifdef USE_FOG
	vFogDepth = - mvPosition.z;
#endif`,Ox=`#ifdef USE_FOG
	varying float vFogDepth;
#endif`,Fx=`#ifdef USE_FOG
	#ifdef FOG_EXP2
		float fogFactor = 1.0 - exp( - fogDensity * fogDensity * vFogDepth * vFogDepth );
	#else
		float fogFactor = smoothstep( fogNear, fogFar, vFogDepth );
	#endif
	gl_FragColor.rgb = mix( gl_FragColor.rgb, fogColor, fogFactor );
#endif`,Bx=`#ifdef USE_FOG
	uniform vec3 fogColor;
	varying float vFogDepth;
	#ifdef FOG_EXP2
		uniform float fogDensity;
	#else
		uniform float fogNear;
		uniform float fogFar;
	#endif
#endif`,zx=`#ifdef USE_GRADIENTMAP
	uniform sampler2D gradientMap;
#endif
vec3 getGradientIrradiance( vec3 normal, vec3 lightDirection ) {
	float dotNL = dot( normal, lightDirection );
	vec2 coord = vec2( dotNL * 0.5 + 0.5, 0.0 );
	#ifdef USE_GRADIENTMAP
		return vec3( texture2D( gradientMap, coord ).r );
	#else
		vec2 fw = fwidth( coord ) * 0.5;
		return mix( vec3( 0.7 ), vec3( 1.0 ), smoothstep( 0.7 - fw.x, 0.7 + fw.x, coord.x ) );
	#endif
}`,kx=`#ifdef USE_LIGHTMAP
	uniform sampler2D lightMap;
	uniform float lightMapIntensity;
#endif`,Gx=`LambertMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularStrength = specularStrength;`,Vx=`varying vec3 vViewPosition;
struct LambertMaterial {
	vec3 diffuseColor;
	float specularStrength;
};
void RE_Direct_Lambert( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Lambert( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in LambertMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Lambert
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Lambert`,Hx=`uniform bool receiveShadow;
uniform vec3 ambientLightColor;
#if defined( USE_LIGHT_PROBES )
	uniform vec3 lightProbe[ 9 ];
#endif
vec3 shGetIrradianceAt( in vec3 normal, in vec3 shCoefficients[ 9 ] ) {
	float x = normal.x, y = normal.y, z = normal.z;
	vec3 result = shCoefficients[ 0 ] * 0.886227;
	result += shCoefficients[ 1 ] * 2.0 * 0.511664 * y;
	result += shCoefficients[ 2 ] * 2.0 * 0.511664 * z;
	result += shCoefficients[ 3 ] * 2.0 * 0.511664 * x;
	result += shCoefficients[ 4 ] * 2.0 * 0.429043 * x * y;
	result += shCoefficients[ 5 ] * 2.0 * 0.429043 * y * z;
	result += shCoefficients[ 6 ] * ( 0.743125 * z * z - 0.247708 );
	result += shCoefficients[ 7 ] * 2.0 * 0.429043 * x * z;
	result += shCoefficients[ 8 ] * 0.429043 * ( x * x - y * y );
	return result;
}
vec3 getLightProbeIrradiance( const in vec3 lightProbe[ 9 ], const in vec3 normal ) {
	vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec3 irradiance = shGetIrradianceAt( worldNormal, lightProbe );
	return irradiance;
}
vec3 getAmbientLightIrradiance( const in vec3 ambientLightColor ) {
	vec3 irradiance = ambientLightColor;
	return irradiance;
}
float getDistanceAttenuation( const in float lightDistance, const in float cutoffDistance, const in float decayExponent ) {
	float distanceFalloff = 1.0 / max( pow( lightDistance, decayExponent ), 0.01 );
	if ( cutoffDistance > 0.0 ) {
		distanceFalloff *= pow2( saturate( 1.0 - pow4( lightDistance / cutoffDistance ) ) );
	}
	return distanceFalloff;
}
float getSpotAttenuation( const in float coneCosine, const in float penumbraCosine, const in float angleCosine ) {
	return smoothstep( coneCosine, penumbraCosine, angleCosine );
}
#if NUM_SUN_LIGHTS > 0
	struct SunLight {
		vec3 direction;
		vec3 color;
	};
	uniform SunLight sunLights[ NUM_SUN_LIGHTS ];
	void getSunLightInfo( const in SunLight sunLight, out IncidentLight light ) {
		light.color = sunLight.color;
		light.direction = sunLight.direction;
		light.visible = true;
	}
#endif
#if NUM_DIR_LIGHTS > 0
	struct DirectionalLight {
		vec3 direction;
		vec3 color;
	};
	uniform DirectionalLight directionalLights[ NUM_DIR_LIGHTS ];
	void getDirectionalLightInfo( const in DirectionalLight directionalLight, out IncidentLight light ) {
		light.color = directionalLight.color;
		light.direction = directionalLight.direction;
		light.visible = true;
	}
#endif
#if NUM_POINT_LIGHTS > 0
	struct PointLight {
		vec3 position;
		vec3 color;
		float distance;
		float decay;
	};
	uniform PointLight pointLights[ NUM_POINT_LIGHTS ];
	void getPointLightInfo( const in PointLight pointLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = pointLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float lightDistance = length( lVector );
		light.color = pointLight.color;
		light.color *= getDistanceAttenuation( lightDistance, pointLight.distance, pointLight.decay );
		light.visible = ( light.color != vec3( 0.0 ) );
	}
#endif
#if NUM_SPOT_LIGHTS > 0
	struct SpotLight {
		vec3 position;
		vec3 direction;
		vec3 color;
		float distance;
		float decay;
		float coneCos;
		float penumbraCos;
	};
	uniform SpotLight spotLights[ NUM_SPOT_LIGHTS ];
	void getSpotLightInfo( const in SpotLight spotLight, const in vec3 geometryPosition, out IncidentLight light ) {
		vec3 lVector = spotLight.position - geometryPosition;
		light.direction = normalize( lVector );
		float angleCos = dot( light.direction, spotLight.direction );
		float spotAttenuation = getSpotAttenuation( spotLight.coneCos, spotLight.penumbraCos, angleCos );
		if ( spotAttenuation > 0.0 ) {
			float lightDistance = length( lVector );
			light.color = spotLight.color * spotAttenuation;
			light.color *= getDistanceAttenuation( lightDistance, spotLight.distance, spotLight.decay );
			light.visible = ( light.color != vec3( 0.0 ) );
		} else {
			light.color = vec3( 0.0 );
			light.visible = false;
		}
	}
#endif
#if NUM_RECT_AREA_LIGHTS > 0
	struct RectAreaLight {
		vec3 color;
		vec3 position;
		vec3 halfWidth;
		vec3 halfHeight;
	};
	uniform sampler2D ltc_1;	uniform sampler2D ltc_2;
	uniform RectAreaLight rectAreaLights[ NUM_RECT_AREA_LIGHTS ];
#endif
#if NUM_HEMI_LIGHTS > 0
	struct HemisphereLight {
		vec3 direction;
		vec3 skyColor;
		vec3 groundColor;
	};
	uniform HemisphereLight hemisphereLights[ NUM_HEMI_LIGHTS ];
	vec3 getHemisphereLightIrradiance( const in HemisphereLight hemiLight, const in vec3 normal ) {
		float dotNL = dot( normal, hemiLight.direction );
		float hemiDiffuseWeight = 0.5 * dotNL + 0.5;
		vec3 irradiance = mix( hemiLight.groundColor, hemiLight.skyColor, hemiDiffuseWeight );
		return irradiance;
	}
#endif
#include <lightprobes_pars_fragment>`,Wx=`#ifdef USE_ENVMAP
	vec3 getIBLIrradiance( const in vec3 normal ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 worldNormal = transformNormalByInverseViewMatrix( normal, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * worldNormal, ENVMAP_MAX_LOD );
			return PI * envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	vec3 getIBLRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
		#ifdef ENVMAP_TYPE_PMREM
			vec3 reflectVec = reflect( - viewDir, normal );
			reflectVec = normalize( mix( reflectVec, normal, pow4( roughness ) ) );
			reflectVec = transformDirectionByInverseViewMatrix( reflectVec, viewMatrix );
			vec4 envMapColor = textureLod( envMap, envMapRotation * reflectVec, roughnessToMip( roughness ) );
			return envMapColor.rgb * envMapIntensity;
		#else
			return vec3( 0.0 );
		#endif
	}
	#ifdef USE_RETROREFLECTION
		vec3 getIBLRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 retroVec = normalize( mix( viewDir, normal, pow4( roughness ) ) );
				retroVec = transformDirectionByInverseViewMatrix( retroVec, viewMatrix );
				vec4 envMapColor = textureLod( envMap, envMapRotation * retroVec, roughnessToMip( roughness ) );
				return envMapColor.rgb * envMapIntensity;
			#else
				return vec3( 0.0 );
			#endif
		}
	#endif
	#ifdef USE_ANISOTROPY
		vec3 getIBLAnisotropyRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
			#ifdef ENVMAP_TYPE_PMREM
				vec3 bentNormal = cross( bitangent, viewDir );
				bentNormal = normalize( cross( bentNormal, bitangent ) );
				bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
				return getIBLRadiance( viewDir, bentNormal, roughness );
			#else
				return vec3( 0.0 );
			#endif
		}
		#ifdef USE_RETROREFLECTION
			vec3 getIBLAnisotropyRetroRadiance( const in vec3 viewDir, const in vec3 normal, const in float roughness, const in vec3 bitangent, const in float anisotropy ) {
				#ifdef ENVMAP_TYPE_PMREM
					vec3 bentNormal = cross( bitangent, viewDir );
					bentNormal = normalize( cross( bentNormal, bitangent ) );
					bentNormal = normalize( mix( bentNormal, normal, pow2( pow2( 1.0 - anisotropy * ( 1.0 - roughness ) ) ) ) );
					return getIBLRetroRadiance( viewDir, bentNormal, roughness );
				#else
					return vec3( 0.0 );
				#endif
			}
		#endif
	#endif
#endif`,qx=`ToonMaterial material;
material.diffuseColor = diffuseColor.rgb;`,Xx=`varying vec3 vViewPosition;
struct ToonMaterial {
	vec3 diffuseColor;
};
void RE_Direct_Toon( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 irradiance = getGradientIrradiance( geometryNormal, directLight.direction ) * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
void RE_IndirectDiffuse_Toon( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in ToonMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_Toon
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Toon`,$x=`BlinnPhongMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.specularColor = specular;
material.specularShininess = shininess;
material.specularStrength = specularStrength;`,Yx=`varying vec3 vViewPosition;
struct BlinnPhongMaterial {
	vec3 diffuseColor;
	vec3 specularColor;
	float specularShininess;
	float specularStrength;
};
void RE_Direct_BlinnPhong( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	reflectedLight.directDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
	reflectedLight.directSpecular += irradiance * BRDF_BlinnPhong( directLight.direction, geometryViewDir, geometryNormal, material.specularColor, material.specularShininess ) * material.specularStrength;
}
void RE_IndirectDiffuse_BlinnPhong( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in BlinnPhongMaterial material, inout ReflectedLight reflectedLight ) {
	reflectedLight.indirectDiffuse += irradiance * BRDF_Lambert( material.diffuseColor );
}
#define RE_Direct				RE_Direct_BlinnPhong
#define RE_IndirectDiffuse		RE_IndirectDiffuse_BlinnPhong`,Zx=`PhysicalMaterial material;
material.diffuseColor = diffuseColor.rgb;
material.diffuseContribution = diffuseColor.rgb * ( 1.0 - metalnessFactor );
material.metalness = metalnessFactor;
vec3 dxy = max( abs( dFdx( nonPerturbedNormal ) ), abs( dFdy( nonPerturbedNormal ) ) );
float geometryRoughness = max( max( dxy.x, dxy.y ), dxy.z );
material.roughness = max( roughnessFactor, 0.045 );
material.roughness += geometryRoughness;
material.roughness = min( material.roughness, 1.0 );
#ifdef USE_DIFFUSE_ROUGHNESS
	float diffuseRoughnessFactor = diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		diffuseRoughnessFactor *= texture2D( diffuseRoughnessMap, vDiffuseRoughnessMapUv ).r;
	#endif
	material.diffuseRoughness = saturate( diffuseRoughnessFactor );
#endif
#ifdef IOR
	material.ior = ior;
	#ifdef USE_SPECULAR
		float specularIntensityFactor = specularIntensity;
		vec3 specularColorFactor = specularColor;
		#ifdef USE_SPECULAR_COLORMAP
			specularColorFactor *= texture2D( specularColorMap, vSpecularColorMapUv ).rgb;
		#endif
		#ifdef USE_SPECULAR_INTENSITYMAP
			specularIntensityFactor *= texture2D( specularIntensityMap, vSpecularIntensityMapUv ).a;
		#endif
		material.specularF90 = mix( specularIntensityFactor, 1.0, metalnessFactor );
	#else
		float specularIntensityFactor = 1.0;
		vec3 specularColorFactor = vec3( 1.0 );
		material.specularF90 = 1.0;
	#endif
	material.specularColor = min( pow2( ( material.ior - 1.0 ) / ( material.ior + 1.0 ) ) * specularColorFactor, vec3( 1.0 ) ) * specularIntensityFactor;
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
#else
	material.specularColor = vec3( 0.04 );
	material.specularColorBlended = mix( material.specularColor, diffuseColor.rgb, metalnessFactor );
	material.specularF90 = 1.0;
#endif
#ifdef USE_CLEARCOAT
	material.clearcoat = clearcoat;
	material.clearcoatRoughness = clearcoatRoughness;
	material.clearcoatF0 = vec3( 0.04 );
	material.clearcoatF90 = 1.0;
	#ifdef USE_CLEARCOATMAP
		material.clearcoat *= texture2D( clearcoatMap, vClearcoatMapUv ).x;
	#endif
	#ifdef USE_CLEARCOAT_ROUGHNESSMAP
		material.clearcoatRoughness *= texture2D( clearcoatRoughnessMap, vClearcoatRoughnessMapUv ).y;
	#endif
	material.clearcoat = saturate( material.clearcoat );	material.clearcoatRoughness = max( material.clearcoatRoughness, 0.045 );
	material.clearcoatRoughness += geometryRoughness;
	material.clearcoatRoughness = min( material.clearcoatRoughness, 1.0 );
#endif
#ifdef USE_DISPERSION
	material.dispersion = dispersion;
#endif
#ifdef USE_RETROREFLECTION
	material.retroreflectivity = retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	material.iridescence = iridescence;
	material.iridescenceIOR = iridescenceIOR;
	#ifdef USE_IRIDESCENCEMAP
		material.iridescence *= texture2D( iridescenceMap, vIridescenceMapUv ).r;
	#endif
	#ifdef USE_IRIDESCENCE_THICKNESSMAP
		material.iridescenceThickness = (iridescenceThicknessMaximum - iridescenceThicknessMinimum) * texture2D( iridescenceThicknessMap, vIridescenceThicknessMapUv ).g + iridescenceThicknessMinimum;
	#else
		material.iridescenceThickness = iridescenceThicknessMaximum;
	#endif
#endif
#ifdef USE_SHEEN
	material.sheenColor = sheenColor;
	#ifdef USE_SHEEN_COLORMAP
		material.sheenColor *= texture2D( sheenColorMap, vSheenColorMapUv ).rgb;
	#endif
	material.sheenRoughness = clamp( sheenRoughness, 0.0001, 1.0 );
	#ifdef USE_SHEEN_ROUGHNESSMAP
		material.sheenRoughness *= texture2D( sheenRoughnessMap, vSheenRoughnessMapUv ).a;
	#endif
#endif
#ifdef USE_ANISOTROPY
	#ifdef USE_ANISOTROPYMAP
		mat2 anisotropyMat = mat2( anisotropyVector.x, anisotropyVector.y, - anisotropyVector.y, anisotropyVector.x );
		vec3 anisotropyPolar = texture2D( anisotropyMap, vAnisotropyMapUv ).rgb;
		vec2 anisotropyV = anisotropyMat * normalize( 2.0 * anisotropyPolar.rg - vec2( 1.0 ) ) * anisotropyPolar.b;
	#else
		vec2 anisotropyV = anisotropyVector;
	#endif
	material.anisotropy = length( anisotropyV );
	if( material.anisotropy == 0.0 ) {
		anisotropyV = vec2( 1.0, 0.0 );
	} else {
		anisotropyV /= material.anisotropy;
		material.anisotropy = saturate( material.anisotropy );
	}
	material.alphaT = mix( pow2( material.roughness ), 1.0, pow2( material.anisotropy ) );
	material.anisotropyT = tbn[ 0 ] * anisotropyV.x + tbn[ 1 ] * anisotropyV.y;
	material.anisotropyB = tbn[ 1 ] * anisotropyV.x - tbn[ 0 ] * anisotropyV.y;
#endif`,Jx=`uniform sampler2D dfgLUT;
struct PhysicalMaterial {
	vec3 diffuseColor;
	vec3 diffuseContribution;
	vec3 specularColor;
	vec3 specularColorBlended;
	float roughness;
	float metalness;
	float specularF90;
	float dispersion;
	vec2 dfg;
	vec3 multiScatteringCompensation;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float diffuseRoughness;
	#endif
	#ifdef USE_RETROREFLECTION
		float retroreflectivity;
	#endif
	#ifdef USE_CLEARCOAT
		float clearcoat;
		float clearcoatRoughness;
		vec3 clearcoatF0;
		float clearcoatF90;
	#endif
	#ifdef USE_IRIDESCENCE
		float iridescence;
		float iridescenceIOR;
		float iridescenceThickness;
		vec3 iridescenceFresnel;
		vec3 iridescenceF0Dielectric;
		vec3 iridescenceF0Metallic;
	#endif
	#ifdef USE_SHEEN
		vec3 sheenColor;
		float sheenRoughness;
	#endif
	#ifdef IOR
		float ior;
	#endif
	#ifdef USE_TRANSMISSION
		float transmission;
		float transmissionAlpha;
		float thickness;
		float attenuationDistance;
		vec3 attenuationColor;
	#endif
	#ifdef USE_ANISOTROPY
		float anisotropy;
		float alphaT;
		vec3 anisotropyT;
		vec3 anisotropyB;
	#endif
};
vec3 clearcoatSpecularDirect = vec3( 0.0 );
vec3 clearcoatSpecularIndirect = vec3( 0.0 );
vec3 sheenSpecularDirect = vec3( 0.0 );
vec3 sheenSpecularIndirect = vec3(0.0 );
vec3 Schlick_to_F0( const in vec3 f, const in float f90, const in float dotVH ) {
    float x = clamp( 1.0 - dotVH, 0.0, 1.0 );
    float x2 = x * x;
    float x5 = clamp( x * x2 * x2, 0.0, 0.9999 );
    return ( f - vec3( f90 ) * x5 ) / ( 1.0 - x5 );
}
#ifdef USE_DIFFUSE_ROUGHNESS
	const float EON_EPSILON = 1e-7;
	float FON_DirectionalAlbedo( const in float mu, const in float roughness, const in float A ) {
		float muComp = 1.0 - mu;
		float gOverPi = muComp * ( 0.0571085289 + muComp * ( 0.491881867 + muComp * ( - 0.332181442 + muComp * 0.0714429953 ) ) );
		return A * ( 1.0 + roughness * gOverPi );
	}
	vec3 BRDF_EON( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in vec3 diffuseColor, const in float roughness ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return BRDF_Lambert( rho );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float s = dot( lightDir, viewDir ) - dotNL * dotNV;
		float sOverT = ( s > 0.0 ) ? s / max( max( dotNL, dotNV ), EON_EPSILON ) : s;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		vec3 singleScatter = rho * RECIPROCAL_PI * A * ( 1.0 + roughness * sOverT );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		float albedoV = FON_DirectionalAlbedo( dotNV, roughness, A );
		float albedoL = FON_DirectionalAlbedo( dotNL, roughness, A );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		vec3 multiScatter = rhoMultiScatter * RECIPROCAL_PI
			* max( EON_EPSILON, 1.0 - albedoV )
			* max( EON_EPSILON, 1.0 - albedoL )
			/ max( EON_EPSILON, 1.0 - averageAlbedo );
		return singleScatter + multiScatter;
	}
	vec3 EON_DirectionalAlbedo( const in vec3 diffuseColor, const in float roughness, const in float dotNV ) {
		vec3 rho = saturate( diffuseColor );
		if ( roughness <= EON_EPSILON ) return rho;
		float A = 1.0 / ( 1.0 + ( 0.5 - 2.0 / ( 3.0 * PI ) ) * roughness );
		float directionalAlbedo = FON_DirectionalAlbedo( dotNV, roughness, A );
		float averageAlbedo = A * ( 1.0 + ( 2.0 / 3.0 - 28.0 / ( 15.0 * PI ) ) * roughness );
		vec3 rhoMultiScatter = rho * rho * averageAlbedo / max( vec3( EON_EPSILON ), vec3( 1.0 ) - rho * ( 1.0 - averageAlbedo ) );
		return rho * directionalAlbedo + rhoMultiScatter * ( 1.0 - directionalAlbedo );
	}
#endif
float V_GGX_SmithCorrelated( const in float alpha, const in float dotNL, const in float dotNV ) {
	float a2 = pow2( alpha );
	float gv = dotNL * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNV ) );
	float gl = dotNV * sqrt( a2 + ( 1.0 - a2 ) * pow2( dotNL ) );
	return 0.5 / max( gv + gl, EPSILON );
}
float D_GGX( const in float alpha, const in float dotNH ) {
	float a2 = pow2( alpha );
	float denom = pow2( dotNH ) * ( a2 - 1.0 ) + 1.0;
	return RECIPROCAL_PI * a2 / pow2( denom );
}
#ifdef USE_ANISOTROPY
	float V_GGX_SmithCorrelated_Anisotropic( const in float alphaT, const in float alphaB, const in float dotTV, const in float dotBV, const in float dotTL, const in float dotBL, const in float dotNV, const in float dotNL ) {
		float gv = dotNL * length( vec3( alphaT * dotTV, alphaB * dotBV, dotNV ) );
		float gl = dotNV * length( vec3( alphaT * dotTL, alphaB * dotBL, dotNL ) );
		return 0.5 / max( gv + gl, EPSILON );
	}
	float D_GGX_Anisotropic( const in float alphaT, const in float alphaB, const in float dotNH, const in float dotTH, const in float dotBH ) {
		float a2 = alphaT * alphaB;
		highp vec3 v = vec3( alphaB * dotTH, alphaT * dotBH, a2 * dotNH );
		highp float v2 = dot( v, v );
		float w2 = a2 / v2;
		return RECIPROCAL_PI * a2 * pow2 ( w2 );
	}
#endif
#ifdef USE_CLEARCOAT
	vec3 BRDF_GGX_Clearcoat( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material) {
		vec3 f0 = material.clearcoatF0;
		float f90 = material.clearcoatF90;
		float roughness = max( material.clearcoatRoughness, 0.045 );
		float alpha = pow2( roughness );
		vec3 halfDir = normalize( lightDir + viewDir );
		float dotNL = saturate( dot( normal, lightDir ) );
		float dotNV = saturate( dot( normal, viewDir ) );
		float dotNH = saturate( dot( normal, halfDir ) );
		float dotVH = saturate( dot( viewDir, halfDir ) );
		vec3 F = F_Schlick( f0, f90, dotVH );
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
		return F * ( V * D );
	}
#endif
vec3 BRDF_GGX( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, const in PhysicalMaterial material ) {
	vec3 f0 = material.specularColorBlended;
	float f90 = material.specularF90;
	float roughness = max( material.roughness, 0.045 );
	float alpha = pow2( roughness );
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float dotVH = saturate( dot( viewDir, halfDir ) );
	vec3 F = F_Schlick( f0, f90, dotVH );
	#ifdef USE_IRIDESCENCE
		F = mix( F, material.iridescenceFresnel, material.iridescence );
	#endif
	#ifdef USE_ANISOTROPY
		float dotTL = dot( material.anisotropyT, lightDir );
		float dotTV = dot( material.anisotropyT, viewDir );
		float dotTH = dot( material.anisotropyT, halfDir );
		float dotBL = dot( material.anisotropyB, lightDir );
		float dotBV = dot( material.anisotropyB, viewDir );
		float dotBH = dot( material.anisotropyB, halfDir );
		float alphaT = max( material.alphaT, alpha );
		float V = V_GGX_SmithCorrelated_Anisotropic( alphaT, alpha, dotTV, dotBV, dotTL, dotBL, dotNV, dotNL );
		float D = D_GGX_Anisotropic( alphaT, alpha, dotNH, dotTH, dotBH );
	#else
		float V = V_GGX_SmithCorrelated( alpha, dotNL, dotNV );
		float D = D_GGX( alpha, dotNH );
	#endif
	return F * ( V * D );
}
vec2 LTC_Uv( const in vec3 N, const in vec3 V, const in float roughness ) {
	const float LUT_SIZE = 64.0;
	const float LUT_SCALE = ( LUT_SIZE - 1.0 ) / LUT_SIZE;
	const float LUT_BIAS = 0.5 / LUT_SIZE;
	float dotNV = saturate( dot( N, V ) );
	vec2 uv = vec2( roughness, sqrt( 1.0 - dotNV ) );
	uv = uv * LUT_SCALE + LUT_BIAS;
	return uv;
}
float LTC_ClippedSphereFormFactor( const in vec3 f ) {
	float l = length( f );
	return max( ( l * l + f.z ) / ( l + 1.0 ), 0.0 );
}
vec3 LTC_EdgeVectorFormFactor( const in vec3 v1, const in vec3 v2 ) {
	float x = dot( v1, v2 );
	float y = abs( x );
	float a = 0.8543985 + ( 0.4965155 + 0.0145206 * y ) * y;
	float b = 3.4175940 + ( 4.1616724 + y ) * y;
	float v = a / b;
	float theta_sintheta = ( x > 0.0 ) ? v : 0.5 * inversesqrt( max( 1.0 - x * x, 1e-7 ) ) - v;
	return cross( v1, v2 ) * theta_sintheta;
}
vec3 LTC_Evaluate( const in vec3 N, const in vec3 V, const in vec3 P, const in mat3 mInv, const in vec3 rectCoords[ 4 ] ) {
	vec3 v1 = rectCoords[ 1 ] - rectCoords[ 0 ];
	vec3 v2 = rectCoords[ 3 ] - rectCoords[ 0 ];
	vec3 lightNormal = cross( v1, v2 );
	if( dot( lightNormal, P - rectCoords[ 0 ] ) < 0.0 ) return vec3( 0.0 );
	vec3 T1, T2;
	T1 = normalize( V - N * dot( V, N ) );
	T2 = - cross( N, T1 );
	mat3 mat = mInv * transpose( mat3( T1, T2, N ) );
	vec3 coords[ 4 ];
	coords[ 0 ] = mat * ( rectCoords[ 0 ] - P );
	coords[ 1 ] = mat * ( rectCoords[ 1 ] - P );
	coords[ 2 ] = mat * ( rectCoords[ 2 ] - P );
	coords[ 3 ] = mat * ( rectCoords[ 3 ] - P );
	coords[ 0 ] = normalize( coords[ 0 ] );
	coords[ 1 ] = normalize( coords[ 1 ] );
	coords[ 2 ] = normalize( coords[ 2 ] );
	coords[ 3 ] = normalize( coords[ 3 ] );
	vec3 vectorFormFactor = vec3( 0.0 );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 0 ], coords[ 1 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 1 ], coords[ 2 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 2 ], coords[ 3 ] );
	vectorFormFactor += LTC_EdgeVectorFormFactor( coords[ 3 ], coords[ 0 ] );
	float result = LTC_ClippedSphereFormFactor( vectorFormFactor );
	return vec3( result );
}
#if defined( USE_SHEEN )
float D_Charlie( float roughness, float dotNH ) {
	float alpha = pow2( roughness );
	float invAlpha = 1.0 / alpha;
	float cos2h = dotNH * dotNH;
	float sin2h = max( 1.0 - cos2h, 0.0078125 );
	return ( 2.0 + invAlpha ) * pow( sin2h, invAlpha * 0.5 ) / ( 2.0 * PI );
}
float V_Neubelt( float dotNV, float dotNL ) {
	return saturate( 1.0 / ( 4.0 * ( dotNL + dotNV - dotNL * dotNV ) ) );
}
vec3 BRDF_Sheen( const in vec3 lightDir, const in vec3 viewDir, const in vec3 normal, vec3 sheenColor, const in float sheenRoughness ) {
	vec3 halfDir = normalize( lightDir + viewDir );
	float dotNL = saturate( dot( normal, lightDir ) );
	float dotNV = saturate( dot( normal, viewDir ) );
	float dotNH = saturate( dot( normal, halfDir ) );
	float D = D_Charlie( sheenRoughness, dotNH );
	float V = V_Neubelt( dotNV, dotNL );
	return sheenColor * ( D * V );
}
#endif
float IBLSheenBRDF( const in vec3 normal, const in vec3 viewDir, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	float r2 = roughness * roughness;
	float rInv = 1.0 / ( roughness + 0.1 );
	float a = -1.9362 + 1.0678 * roughness + 0.4573 * r2 - 0.8469 * rInv;
	float b = -0.6014 + 0.5538 * roughness - 0.4670 * r2 - 0.1255 * rInv;
	float DG = exp( a * dotNV + b );
	return saturate( DG );
}
vec3 EnvironmentBRDF( const in vec3 normal, const in vec3 viewDir, const in vec3 specularColor, const in float specularF90, const in float roughness ) {
	float dotNV = saturate( dot( normal, viewDir ) );
	vec2 fab = texture2D( dfgLUT, vec2( roughness, dotNV ) ).rg;
	return specularColor * fab.x + specularF90 * fab.y;
}
#ifdef USE_IRIDESCENCE
void computeMultiscatteringIridescence( const in vec2 fab, const in vec3 specularColor, const in float specularF90, const in float iridescence, const in vec3 iridescenceF0, inout vec3 singleScatter, inout vec3 multiScatter ) {
#else
void computeMultiscattering( const in vec2 fab, const in vec3 specularColor, const in float specularF90, inout vec3 singleScatter, inout vec3 multiScatter ) {
#endif
	#ifdef USE_IRIDESCENCE
		vec3 Fr = mix( specularColor, iridescenceF0, iridescence );
	#else
		vec3 Fr = specularColor;
	#endif
	vec3 FssEss = Fr * fab.x + specularF90 * fab.y;
	float Ess = fab.x + fab.y;
	float Ems = 1.0 - Ess;
	vec3 Favg = Fr + ( 1.0 - Fr ) * 0.047619;	vec3 Fms = FssEss * Favg / ( 1.0 - Ems * Favg );
	singleScatter += FssEss;
	multiScatter += Fms * Ems;
}
#if NUM_RECT_AREA_LIGHTS > 0
	void RE_Direct_RectArea_Physical( const in RectAreaLight rectAreaLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
		vec3 normal = geometryNormal;
		vec3 viewDir = geometryViewDir;
		vec3 position = geometryPosition;
		vec3 lightPos = rectAreaLight.position;
		vec3 halfWidth = rectAreaLight.halfWidth;
		vec3 halfHeight = rectAreaLight.halfHeight;
		vec3 lightColor = rectAreaLight.color;
		float roughness = material.roughness;
		vec3 rectCoords[ 4 ];
		rectCoords[ 0 ] = lightPos + halfWidth - halfHeight;		rectCoords[ 1 ] = lightPos - halfWidth - halfHeight;
		rectCoords[ 2 ] = lightPos - halfWidth + halfHeight;
		rectCoords[ 3 ] = lightPos + halfWidth + halfHeight;
		vec2 uv = LTC_Uv( normal, viewDir, roughness );
		vec4 t1 = texture2D( ltc_1, uv );
		vec4 t2 = texture2D( ltc_2, uv );
		mat3 mInv = mat3(
			vec3( t1.x, 0, t1.y ),
			vec3(    0, 1,    0 ),
			vec3( t1.z, 0, t1.w )
		);
		vec3 fresnel = ( material.specularColorBlended * t2.x + ( material.specularF90 - material.specularColorBlended ) * t2.y );
		reflectedLight.directSpecular += lightColor * fresnel * LTC_Evaluate( normal, viewDir, position, mInv, rectCoords );
		reflectedLight.directDiffuse += lightColor * material.diffuseContribution * LTC_Evaluate( normal, viewDir, position, mat3( 1.0 ), rectCoords );
		#ifdef USE_CLEARCOAT
			vec3 Ncc = geometryClearcoatNormal;
			vec2 uvClearcoat = LTC_Uv( Ncc, viewDir, material.clearcoatRoughness );
			vec4 t1Clearcoat = texture2D( ltc_1, uvClearcoat );
			vec4 t2Clearcoat = texture2D( ltc_2, uvClearcoat );
			mat3 mInvClearcoat = mat3(
				vec3( t1Clearcoat.x, 0, t1Clearcoat.y ),
				vec3(             0, 1,             0 ),
				vec3( t1Clearcoat.z, 0, t1Clearcoat.w )
			);
			vec3 fresnelClearcoat = material.clearcoatF0 * t2Clearcoat.x + ( material.clearcoatF90 - material.clearcoatF0 ) * t2Clearcoat.y;
			clearcoatSpecularDirect += lightColor * fresnelClearcoat * LTC_Evaluate( Ncc, viewDir, position, mInvClearcoat, rectCoords );
		#endif
	}
#endif
void RE_Direct_Physical( const in IncidentLight directLight, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	float dotNL = saturate( dot( geometryNormal, directLight.direction ) );
	vec3 irradiance = dotNL * directLight.color;
	#ifdef USE_CLEARCOAT
		float dotNLcc = saturate( dot( geometryClearcoatNormal, directLight.direction ) );
		vec3 ccIrradiance = dotNLcc * directLight.color;
		clearcoatSpecularDirect += ccIrradiance * BRDF_GGX_Clearcoat( directLight.direction, geometryViewDir, geometryClearcoatNormal, material );
	#endif
	#ifdef USE_SHEEN
 
 		sheenSpecularDirect += irradiance * BRDF_Sheen( directLight.direction, geometryViewDir, geometryNormal, material.sheenColor, material.sheenRoughness );
 
 		float sheenAlbedoV = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
 		float sheenAlbedoL = IBLSheenBRDF( geometryNormal, directLight.direction, material.sheenRoughness );
 
 		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * max( sheenAlbedoV, sheenAlbedoL );
 
 		irradiance *= sheenEnergyComp;
 
 	#endif
	vec3 specularBRDF = BRDF_GGX( directLight.direction, geometryViewDir, geometryNormal, material );
	#ifdef USE_RETROREFLECTION
		vec3 retroViewDir = reflect( - geometryViewDir, geometryNormal );
		vec3 retroSpecularBRDF = BRDF_GGX( directLight.direction, retroViewDir, geometryNormal, material );
		specularBRDF = mix( specularBRDF, retroSpecularBRDF, saturate( material.retroreflectivity ) );
	#endif
	reflectedLight.directSpecular += irradiance * specularBRDF * material.multiScatteringCompensation;
	vec3 halfDir = normalize( directLight.direction + geometryViewDir );
	float dotVH = saturate( dot( geometryViewDir, halfDir ) );
	vec3 F = F_Schlick( material.specularColor, material.specularF90, dotVH );
	#ifdef USE_RETROREFLECTION
		vec3 retroHalfDir = normalize( directLight.direction + retroViewDir );
		float dotRetroVH = saturate( dot( retroViewDir, retroHalfDir ) );
		vec3 retroF = F_Schlick( material.specularColor, material.specularF90, dotRetroVH );
		F = mix( F, retroF, saturate( material.retroreflectivity ) );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		vec3 diffuseBRDF = BRDF_EON( directLight.direction, geometryViewDir, geometryNormal, material.diffuseColor, material.diffuseRoughness ) * ( 1.0 - material.metalness );
	#else
		vec3 diffuseBRDF = BRDF_Lambert( material.diffuseContribution );
	#endif
	reflectedLight.directDiffuse += irradiance * diffuseBRDF * ( 1.0 - F );
}
void RE_IndirectDiffuse_Physical( const in vec3 irradiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight ) {
	vec3 singleScattering = vec3( 0.0 );
	vec3 multiScattering = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScattering, multiScattering );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScattering, multiScattering );
	#endif
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuseAlbedo = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness );
		vec3 diffuse = irradiance * RECIPROCAL_PI * diffuseAlbedo * ( 1.0 - singleScattering - multiScattering );
	#else
		vec3 diffuse = irradiance * BRDF_Lambert( material.diffuseContribution ) * ( 1.0 - singleScattering - multiScattering );
	#endif
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		sheenSpecularIndirect += irradiance * material.sheenColor * sheenAlbedo * RECIPROCAL_PI;
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		diffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectDiffuse += diffuse;
}
void RE_IndirectSpecular_Physical( const in vec3 radiance, const in vec3 irradiance, const in vec3 clearcoatRadiance, const in vec3 geometryPosition, const in vec3 geometryNormal, const in vec3 geometryViewDir, const in vec3 geometryClearcoatNormal, const in PhysicalMaterial material, inout ReflectedLight reflectedLight) {
	#ifdef USE_CLEARCOAT
		clearcoatSpecularIndirect += clearcoatRadiance * EnvironmentBRDF( geometryClearcoatNormal, geometryViewDir, material.clearcoatF0, material.clearcoatF90, material.clearcoatRoughness );
	#endif
	#ifdef USE_SHEEN
		sheenSpecularIndirect += irradiance * material.sheenColor * IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness ) * RECIPROCAL_PI;
 	#endif
	vec3 singleScatteringDielectric = vec3( 0.0 );
	vec3 multiScatteringDielectric = vec3( 0.0 );
	vec3 singleScatteringMetallic = vec3( 0.0 );
	vec3 multiScatteringMetallic = vec3( 0.0 );
	#ifdef USE_IRIDESCENCE
		computeMultiscatteringIridescence( material.dfg, material.specularColor, material.specularF90, material.iridescence, material.iridescenceF0Dielectric, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscatteringIridescence( material.dfg, material.diffuseColor, material.specularF90, material.iridescence, material.iridescenceF0Metallic, singleScatteringMetallic, multiScatteringMetallic );
	#else
		computeMultiscattering( material.dfg, material.specularColor, material.specularF90, singleScatteringDielectric, multiScatteringDielectric );
		computeMultiscattering( material.dfg, material.diffuseColor, material.specularF90, singleScatteringMetallic, multiScatteringMetallic );
	#endif
	vec3 singleScattering = mix( singleScatteringDielectric, singleScatteringMetallic, material.metalness );
	vec3 multiScattering = mix( multiScatteringDielectric, multiScatteringMetallic, material.metalness );
	vec3 totalScatteringDielectric = singleScatteringDielectric + multiScatteringDielectric;
	#ifdef USE_DIFFUSE_ROUGHNESS
		float dotNV = saturate( dot( geometryNormal, geometryViewDir ) );
		vec3 diffuse = EON_DirectionalAlbedo( material.diffuseColor, material.diffuseRoughness, dotNV ) * ( 1.0 - material.metalness ) * ( 1.0 - totalScatteringDielectric );
	#else
		vec3 diffuse = material.diffuseContribution * ( 1.0 - totalScatteringDielectric );
	#endif
	vec3 cosineWeightedIrradiance = irradiance * RECIPROCAL_PI;
	vec3 indirectSpecular = radiance * singleScattering;
	indirectSpecular += multiScattering * cosineWeightedIrradiance;
	vec3 indirectDiffuse = diffuse * cosineWeightedIrradiance;
	#ifdef USE_SHEEN
		float sheenAlbedo = IBLSheenBRDF( geometryNormal, geometryViewDir, material.sheenRoughness );
		float sheenEnergyComp = 1.0 - max3( material.sheenColor ) * sheenAlbedo;
		indirectSpecular *= sheenEnergyComp;
		indirectDiffuse *= sheenEnergyComp;
	#endif
	reflectedLight.indirectSpecular += indirectSpecular;
	reflectedLight.indirectDiffuse += indirectDiffuse;
}
#define RE_Direct				RE_Direct_Physical
#define RE_Direct_RectArea		RE_Direct_RectArea_Physical
#define RE_IndirectDiffuse		RE_IndirectDiffuse_Physical
#define RE_IndirectSpecular		RE_IndirectSpecular_Physical
float computeSpecularOcclusion( const in float dotNV, const in float ambientOcclusion, const in float roughness ) {
	return saturate( pow( dotNV + ambientOcclusion, exp2( - 16.0 * roughness - 1.0 ) ) - 1.0 + ambientOcclusion );
}`,Kx=`
vec3 geometryPosition = - vViewPosition;
vec3 geometryNormal = normal;
vec3 geometryViewDir = ( isOrthographic ) ? vec3( 0, 0, 1 ) : normalize( vViewPosition );
vec3 geometryClearcoatNormal = vec3( 0.0 );
#ifdef USE_CLEARCOAT
	geometryClearcoatNormal = clearcoatNormal;
#endif
#ifdef USE_IRIDESCENCE
	float dotNVi = saturate( dot( normal, geometryViewDir ) );
	if ( material.iridescenceThickness == 0.0 ) {
		material.iridescence = 0.0;
	} else {
		material.iridescence = saturate( material.iridescence );
	}
	if ( material.iridescence > 0.0 ) {
		vec3 iridescenceFresnelDielectric = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.specularColor );
		vec3 iridescenceFresnelMetallic = evalIridescence( 1.0, material.iridescenceIOR, dotNVi, material.iridescenceThickness, material.diffuseColor );
		material.iridescenceFresnel = mix( iridescenceFresnelDielectric, iridescenceFresnelMetallic, material.metalness );
		material.iridescenceF0Dielectric = Schlick_to_F0( iridescenceFresnelDielectric, 1.0, dotNVi );
		material.iridescenceF0Metallic = Schlick_to_F0( iridescenceFresnelMetallic, 1.0, dotNVi );
	}
#endif
#ifdef STANDARD
	float dotNVms = saturate( dot( geometryNormal, geometryViewDir ) );
	material.dfg = texture2D( dfgLUT, vec2( material.roughness, dotNVms ) ).rg;
	#if ( NUM_SUN_LIGHTS > 0 || NUM_DIR_LIGHTS > 0 || NUM_POINT_LIGHTS > 0 || NUM_SPOT_LIGHTS > 0 )
		float EssMs = material.dfg.x + material.dfg.y;
		material.multiScatteringCompensation = 1.0 + material.specularColorBlended * ( 1.0 / EssMs - 1.0 );
	#endif
#endif
IncidentLight directLight;
#if ( NUM_POINT_LIGHTS > 0 ) && defined( RE_Direct )
	PointLight pointLight;
	#if defined( USE_SHADOWMAP ) && NUM_POINT_LIGHT_SHADOWS > 0
	PointLightShadow pointLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHTS; i ++ ) {
		pointLight = pointLights[ i ];
		getPointLightInfo( pointLight, geometryPosition, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_POINT_LIGHT_SHADOWS ) && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
		pointLightShadow = pointLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getPointShadow( pointShadowMap[ i ], pointLightShadow.shadowMapSize, pointLightShadow.shadowIntensity, pointLightShadow.shadowBias, pointLightShadow.shadowRadius, vPointShadowCoord[ i ], pointLightShadow.shadowCameraNear, pointLightShadow.shadowCameraFar ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SPOT_LIGHTS > 0 ) && defined( RE_Direct )
	SpotLight spotLight;
	vec4 spotColor;
	vec3 spotLightCoord;
	bool inSpotLightMap;
	#if defined( USE_SHADOWMAP ) && NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHTS; i ++ ) {
		spotLight = spotLights[ i ];
		getSpotLightInfo( spotLight, geometryPosition, directLight );
		#if ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#define SPOT_LIGHT_MAP_INDEX UNROLLED_LOOP_INDEX
		#elif ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		#define SPOT_LIGHT_MAP_INDEX NUM_SPOT_LIGHT_MAPS
		#else
		#define SPOT_LIGHT_MAP_INDEX ( UNROLLED_LOOP_INDEX - NUM_SPOT_LIGHT_SHADOWS + NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS )
		#endif
		#if ( SPOT_LIGHT_MAP_INDEX < NUM_SPOT_LIGHT_MAPS )
			spotLightCoord = vSpotLightCoord[ i ].xyz / vSpotLightCoord[ i ].w;
			inSpotLightMap = all( lessThan( abs( spotLightCoord * 2. - 1. ), vec3( 1.0 ) ) );
			spotColor = texture2D( spotLightMap[ SPOT_LIGHT_MAP_INDEX ], spotLightCoord.xy );
			directLight.color = inSpotLightMap ? directLight.color * spotColor.rgb : directLight.color;
		#endif
		#undef SPOT_LIGHT_MAP_INDEX
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
		spotLightShadow = spotLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( spotShadowMap[ i ], spotLightShadow.shadowMapSize, spotLightShadow.shadowIntensity, spotLightShadow.shadowBias, spotLightShadow.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_SUN_LIGHTS > 0 ) && defined( RE_Direct )
	SunLight sunLight;
	#if defined( USE_SHADOWMAP ) && NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHTS; i ++ ) {
		sunLight = sunLights[ i ];
		getSunLightInfo( sunLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_SUN_LIGHT_SHADOWS )
		sunLightShadow = sunLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getSunShadow( sunShadowMap[ i ], sunLightShadow, UNROLLED_LOOP_INDEX ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_DIR_LIGHTS > 0 ) && defined( RE_Direct )
	DirectionalLight directionalLight;
	#if defined( USE_SHADOWMAP ) && NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLightShadow;
	#endif
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHTS; i ++ ) {
		directionalLight = directionalLights[ i ];
		getDirectionalLightInfo( directionalLight, directLight );
		#if defined( USE_SHADOWMAP ) && ( UNROLLED_LOOP_INDEX < NUM_DIR_LIGHT_SHADOWS )
		directionalLightShadow = directionalLightShadows[ i ];
		directLight.color *= ( directLight.visible && receiveShadow ) ? getShadow( directionalShadowMap[ i ], directionalLightShadow.shadowMapSize, directionalLightShadow.shadowIntensity, directionalLightShadow.shadowBias, directionalLightShadow.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
		#endif
		RE_Direct( directLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if ( NUM_RECT_AREA_LIGHTS > 0 ) && defined( RE_Direct_RectArea )
	RectAreaLight rectAreaLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_RECT_AREA_LIGHTS; i ++ ) {
		rectAreaLight = rectAreaLights[ i ];
		RE_Direct_RectArea( rectAreaLight, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
	}
	#pragma unroll_loop_end
#endif
#if defined( RE_IndirectDiffuse )
	vec3 iblIrradiance = vec3( 0.0 );
	vec3 irradiance = getAmbientLightIrradiance( ambientLightColor );
	#if defined( USE_LIGHT_PROBES )
		irradiance += getLightProbeIrradiance( lightProbe, geometryNormal );
	#endif
	#if ( NUM_HEMI_LIGHTS > 0 )
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_HEMI_LIGHTS; i ++ ) {
			irradiance += getHemisphereLightIrradiance( hemisphereLights[ i ], geometryNormal );
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_LIGHT_PROBE_GRIDS > 0
		vec3 probeWorldPos = ( ( vec4( geometryPosition, 1.0 ) - viewMatrix[ 3 ] ) * viewMatrix ).xyz;
		vec3 probeWorldNormal = transformNormalByInverseViewMatrix( geometryNormal, viewMatrix );
		int probeGrid = - 1;
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( isInsideLightProbeGrid( probeWorldPos, probeWorldNormal, probesMin[ i ], probesMax[ i ], probesResolution[ i ] ) ) probeGrid = UNROLLED_LOOP_INDEX;
		}
		#pragma unroll_loop_end
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_LIGHT_PROBE_GRIDS; i ++ ) {
			if ( probeGrid == UNROLLED_LOOP_INDEX ) irradiance += getLightProbeGridIrradiance( probesSH[ i ], probesMin[ i ], probesMax[ i ], probesResolution[ i ], probeWorldPos, probeWorldNormal );
		}
		#pragma unroll_loop_end
	#endif
#endif
#if defined( RE_IndirectSpecular )
	vec3 radiance = vec3( 0.0 );
	vec3 clearcoatRadiance = vec3( 0.0 );
#endif`,jx=`#if defined( RE_IndirectDiffuse )
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		vec3 lightMapIrradiance = lightMapTexel.rgb * lightMapIntensity;
		irradiance += lightMapIrradiance;
	#endif
	#if defined( USE_ENVMAP ) && defined( ENVMAP_TYPE_PMREM )
		#if defined( STANDARD ) || defined( LAMBERT ) || defined( PHONG )
			iblIrradiance += getIBLIrradiance( geometryNormal );
		#endif
	#endif
#endif
#if defined( USE_ENVMAP ) && defined( RE_IndirectSpecular )
	#ifdef USE_ANISOTROPY
		vec3 iblRadiance = getIBLAnisotropyRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
	#else
		vec3 iblRadiance = getIBLRadiance( geometryViewDir, geometryNormal, material.roughness );
	#endif
	#ifdef USE_RETROREFLECTION
		#ifdef USE_ANISOTROPY
			vec3 retroIBLRadiance = getIBLAnisotropyRetroRadiance( geometryViewDir, geometryNormal, material.roughness, material.anisotropyB, material.anisotropy );
		#else
			vec3 retroIBLRadiance = getIBLRetroRadiance( geometryViewDir, geometryNormal, material.roughness );
		#endif
		iblRadiance = mix( iblRadiance, retroIBLRadiance, saturate( material.retroreflectivity ) );
	#endif
	radiance += iblRadiance;
	#ifdef USE_CLEARCOAT
		clearcoatRadiance += getIBLRadiance( geometryViewDir, geometryClearcoatNormal, material.clearcoatRoughness );
	#endif
#endif`,Qx=`#if defined( RE_IndirectDiffuse )
	#if defined( LAMBERT ) || defined( PHONG )
		irradiance += iblIrradiance;
	#endif
	RE_IndirectDiffuse( irradiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif
#if defined( RE_IndirectSpecular )
	RE_IndirectSpecular( radiance, iblIrradiance, clearcoatRadiance, geometryPosition, geometryNormal, geometryViewDir, geometryClearcoatNormal, material, reflectedLight );
#endif`,t_=`#if NUM_LIGHT_PROBE_GRIDS > 0
uniform highp sampler3D probesSH[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMin[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesMax[ NUM_LIGHT_PROBE_GRIDS ];
uniform vec3 probesResolution[ NUM_LIGHT_PROBE_GRIDS ];
bool isInsideLightProbeGrid( vec3 worldPos, vec3 worldNormal, vec3 probesMin, vec3 probesMax, vec3 probesResolution ) {
	vec3 spacing = ( probesMax - probesMin ) / probesResolution;
	vec3 samplePos = worldPos + worldNormal * spacing * 0.5;
	vec3 margin = spacing * 0.01;
	return all( greaterThanEqual( samplePos, probesMin - margin ) ) && all( lessThanEqual( samplePos, probesMax + margin ) );
}
vec3 getLightProbeGridIrradiance( highp sampler3D probesSH, vec3 probesMin, vec3 probesMax, vec3 probesResolution, vec3 worldPos, vec3 worldNormal ) {
	vec3 res = probesResolution;
	vec3 gridRange = probesMax - probesMin;
	vec3 probeSpacing = gridRange / res;
	vec3 samplePos = worldPos + worldNormal * probeSpacing * 0.5;
	vec3 uvw = clamp( ( samplePos - probesMin ) / gridRange, 0.5 / res, 1.0 - 0.5 / res );
	float nz          = res.z;
	float paddedSlices = nz + 2.0;
	float atlasDepth  = 7.0 * paddedSlices;
	float uvZBase     = uvw.z * nz + 1.0;
	vec4 s0 = texture( probesSH, vec3( uvw.xy, ( uvZBase                       ) / atlasDepth ) );
	vec4 s1 = texture( probesSH, vec3( uvw.xy, ( uvZBase +       paddedSlices   ) / atlasDepth ) );
	vec4 s2 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 2.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s3 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 3.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s4 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 4.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s5 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 5.0 * paddedSlices   ) / atlasDepth ) );
	vec4 s6 = texture( probesSH, vec3( uvw.xy, ( uvZBase + 6.0 * paddedSlices   ) / atlasDepth ) );
	vec3 c0 = s0.xyz;
	vec3 c1 = vec3( s0.w, s1.xy );
	vec3 c2 = vec3( s1.zw, s2.x );
	vec3 c3 = s2.yzw;
	vec3 c4 = s3.xyz;
	vec3 c5 = vec3( s3.w, s4.xy );
	vec3 c6 = vec3( s4.zw, s5.x );
	vec3 c7 = s5.yzw;
	vec3 c8 = s6.xyz;
	float x = worldNormal.x, y = worldNormal.y, z = worldNormal.z;
	vec3 result = c0 * 0.886227;
	result += c1 * 2.0 * 0.511664 * y;
	result += c2 * 2.0 * 0.511664 * z;
	result += c3 * 2.0 * 0.511664 * x;
	result += c4 * 2.0 * 0.429043 * x * y;
	result += c5 * 2.0 * 0.429043 * y * z;
	result += c6 * ( 0.743125 * z * z - 0.247708 );
	result += c7 * 2.0 * 0.429043 * x * z;
	result += c8 * 0.429043 * ( x * x - y * y );
	return max( result, vec3( 0.0 ) );
}
#endif`,e_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	gl_FragDepth = vIsPerspective == 0.0 ? gl_FragCoord.z : log2( vFragDepth ) * logDepthBufFC * 0.5;
#endif`,n_=`#if defined( USE_LOGARITHMIC_DEPTH_BUFFER )
	uniform float logDepthBufFC;
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,i_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	varying float vFragDepth;
	varying float vIsPerspective;
#endif`,s_=`#ifdef USE_LOGARITHMIC_DEPTH_BUFFER
	vFragDepth = 1.0 + gl_Position.w;
	vIsPerspective = float( isPerspectiveMatrix( projectionMatrix ) );
#endif`,r_=`#ifdef USE_MAP
	vec4 sampledDiffuseColor = texture2D( map, vMapUv );
	#ifdef DECODE_VIDEO_TEXTURE
		sampledDiffuseColor = sRGBTransferEOTF( sampledDiffuseColor );
	#endif
	diffuseColor *= sampledDiffuseColor;
#endif`,o_=`#ifdef USE_MAP
	uniform sampler2D map;
#endif`,a_=`#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
	#if defined( USE_POINTS_UV )
		vec2 uv = vUv;
	#else
		vec2 uv = ( uvTransform * vec3( gl_PointCoord.x, 1.0 - gl_PointCoord.y, 1 ) ).xy;
	#endif
#endif
#ifdef USE_MAP
	diffuseColor *= texture2D( map, uv );
#endif
#ifdef USE_ALPHAMAP
	diffuseColor.a *= texture2D( alphaMap, uv ).g;
#endif`,c_=`#if defined( USE_POINTS_UV )
	varying vec2 vUv;
#else
	#if defined( USE_MAP ) || defined( USE_ALPHAMAP )
		uniform mat3 uvTransform;
	#endif
#endif
#ifdef USE_MAP
	uniform sampler2D map;
#endif
#ifdef USE_ALPHAMAP
	uniform sampler2D alphaMap;
#endif`,l_=`float metalnessFactor = metalness;
#ifdef USE_METALNESSMAP
	vec4 texelMetalness = texture2D( metalnessMap, vMetalnessMapUv );
	metalnessFactor *= texelMetalness.b;
#endif`,h_=`#ifdef USE_METALNESSMAP
	uniform sampler2D metalnessMap;
#endif`,u_=`#ifdef USE_INSTANCING_MORPH
	float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	float morphTargetBaseInfluence = texelFetch( morphTexture, ivec2( 0, gl_InstanceID ), 0 ).r;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		morphTargetInfluences[i] =  texelFetch( morphTexture, ivec2( i + 1, gl_InstanceID ), 0 ).r;
	}
#endif`,d_=`#if defined( USE_MORPHCOLORS )
	#if defined( USE_COLOR_ALPHA )
		vColor *= morphTargetBaseInfluence;
	#elif defined( USE_COLOR )
		vColor.rgb *= morphTargetBaseInfluence;
	#endif
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		#if defined( USE_COLOR_ALPHA )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor += getMorph( gl_VertexID, i, 2 ) * morphTargetInfluences[ i ];
		#elif defined( USE_COLOR )
			if ( morphTargetInfluences[ i ] != 0.0 ) vColor.rgb += getMorph( gl_VertexID, i, 2 ).rgb * morphTargetInfluences[ i ];
		#endif
	}
#endif`,f_=`#ifdef USE_MORPHNORMALS
	objectNormal *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) objectNormal += getMorph( gl_VertexID, i, 1 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,p_=`#ifdef USE_MORPHTARGETS
	#ifndef USE_INSTANCING_MORPH
		uniform float morphTargetBaseInfluence;
		uniform float morphTargetInfluences[ MORPHTARGETS_COUNT ];
	#endif
	uniform sampler2DArray morphTargetsTexture;
	uniform ivec2 morphTargetsTextureSize;
	vec4 getMorph( const in int vertexIndex, const in int morphTargetIndex, const in int offset ) {
		int texelIndex = vertexIndex * MORPHTARGETS_TEXTURE_STRIDE + offset;
		int y = texelIndex / morphTargetsTextureSize.x;
		int x = texelIndex - y * morphTargetsTextureSize.x;
		ivec3 morphUV = ivec3( x, y, morphTargetIndex );
		return texelFetch( morphTargetsTexture, morphUV, 0 );
	}
#endif`,m_=`#ifdef USE_MORPHTARGETS
	transformed *= morphTargetBaseInfluence;
	for ( int i = 0; i < MORPHTARGETS_COUNT; i ++ ) {
		if ( morphTargetInfluences[ i ] != 0.0 ) transformed += getMorph( gl_VertexID, i, 0 ).xyz * morphTargetInfluences[ i ];
	}
#endif`,g_=`float faceDirection = gl_FrontFacing ? 1.0 : - 1.0;
#ifdef FLAT_SHADED
	vec3 fdx = dFdx( vViewPosition );
	vec3 fdy = dFdy( vViewPosition );
	vec3 normal = normalize( cross( fdx, fdy ) );
#else
	vec3 normal = normalize( vNormal );
	#ifdef DOUBLE_SIDED
		normal *= faceDirection;
	#endif
#endif
#if defined( USE_NORMALMAP_TANGENTSPACE ) || defined( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY )
	#ifdef USE_TANGENT
		mat3 tbn = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn = getTangentFrame( - vViewPosition, normal,
		#if defined( USE_NORMALMAP )
			vNormalMapUv
		#elif defined( USE_CLEARCOAT_NORMALMAP )
			vClearcoatNormalMapUv
		#else
			vUv
		#endif
		);
	#endif
	#ifdef DOUBLE_SIDED
		tbn[0] *= faceDirection;
		tbn[1] *= faceDirection;
	#endif
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	#ifdef USE_TANGENT
		mat3 tbn2 = mat3( normalize( vTangent ), normalize( vBitangent ), normal );
	#else
		mat3 tbn2 = getTangentFrame( - vViewPosition, normal, vClearcoatNormalMapUv );
	#endif
	#ifdef DOUBLE_SIDED
		tbn2[0] *= faceDirection;
		tbn2[1] *= faceDirection;
	#endif
#endif
vec3 nonPerturbedNormal = normal;`,x_=`#ifdef USE_NORMALMAP_OBJECTSPACE
	normal = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#ifdef FLIP_SIDED
		normal = - normal;
	#endif
	#ifdef DOUBLE_SIDED
		normal = normal * faceDirection;
	#endif
	normal = normalize( normalMatrix * normal );
#elif defined( USE_NORMALMAP_TANGENTSPACE )
	vec3 mapN = texture2D( normalMap, vNormalMapUv ).xyz * 2.0 - 1.0;
	#if defined( USE_PACKED_NORMALMAP )
		mapN = vec3( mapN.xy, sqrt( saturate( 1.0 - dot( mapN.xy, mapN.xy ) ) ) );
	#endif
	mapN.xy *= normalScale;
	normal = normalize( tbn * mapN );
#elif defined( USE_BUMPMAP )
	normal = perturbNormalArb( - vViewPosition, normal, dHdxy_fwd(), faceDirection );
#endif`,__=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,y_=`#ifndef FLAT_SHADED
	varying vec3 vNormal;
	#ifdef USE_TANGENT
		varying vec3 vTangent;
		varying vec3 vBitangent;
	#endif
#endif`,v_=`#ifndef FLAT_SHADED
	vNormal = normalize( transformedNormal );
	#ifdef USE_TANGENT
		vTangent = normalize( transformedTangent );
		vBitangent = normalize( cross( vNormal, vTangent ) * tangent.w );
		#ifdef FLIP_SIDED
			vBitangent = - vBitangent;
		#endif
	#endif
#endif`,M_=`#ifdef USE_NORMALMAP
	uniform sampler2D normalMap;
	uniform vec2 normalScale;
#endif
#ifdef USE_NORMALMAP_OBJECTSPACE
	uniform mat3 normalMatrix;
#endif
#if ! defined ( USE_TANGENT ) && ( defined ( USE_NORMALMAP_TANGENTSPACE ) || defined ( USE_CLEARCOAT_NORMALMAP ) || defined( USE_ANISOTROPY ) )
	mat3 getTangentFrame( vec3 eye_pos, vec3 surf_norm, vec2 uv ) {
		vec3 q0 = dFdx( eye_pos.xyz );
		vec3 q1 = dFdy( eye_pos.xyz );
		vec2 st0 = dFdx( uv.st );
		vec2 st1 = dFdy( uv.st );
		vec3 N = surf_norm;
		vec3 q1perp = cross( q1, N );
		vec3 q0perp = cross( N, q0 );
		vec3 T = q1perp * st0.x + q0perp * st1.x;
		vec3 B = q1perp * st0.y + q0perp * st1.y;
		float det = max( dot( T, T ), dot( B, B ) );
		float scale = ( det == 0.0 ) ? 0.0 : inversesqrt( det );
		return mat3( T * scale, B * scale, N );
	}
#endif`,S_=`#ifdef USE_CLEARCOAT
	vec3 clearcoatNormal = nonPerturbedNormal;
#endif`,b_=`#ifdef USE_CLEARCOAT_NORMALMAP
	vec3 clearcoatMapN = texture2D( clearcoatNormalMap, vClearcoatNormalMapUv ).xyz * 2.0 - 1.0;
	clearcoatMapN.xy *= clearcoatNormalScale;
	clearcoatNormal = normalize( tbn2 * clearcoatMapN );
#endif`,w_=`#ifdef USE_CLEARCOATMAP
	uniform sampler2D clearcoatMap;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform sampler2D clearcoatNormalMap;
	uniform vec2 clearcoatNormalScale;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform sampler2D clearcoatRoughnessMap;
#endif`,A_=`#ifdef USE_IRIDESCENCEMAP
	uniform sampler2D iridescenceMap;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform sampler2D iridescenceThicknessMap;
#endif`,E_=`#ifdef OPAQUE
diffuseColor.a = 1.0;
#endif
#ifdef USE_TRANSMISSION
diffuseColor.a *= material.transmissionAlpha;
#endif
gl_FragColor = vec4( outgoingLight, diffuseColor.a );`,T_=`vec3 packNormalToRGB( const in vec3 normal ) {
	return normalize( normal ) * 0.5 + 0.5;
}
vec3 unpackRGBToNormal( const in vec3 rgb ) {
	return 2.0 * rgb.xyz - 1.0;
}
const float PackUpscale = 256. / 255.;const float UnpackDownscale = 255. / 256.;const float ShiftRight8 = 1. / 256.;
const float Inv255 = 1. / 255.;
const vec4 PackFactors = vec4( 1.0, 256.0, 256.0 * 256.0, 256.0 * 256.0 * 256.0 );
const vec2 UnpackFactors2 = vec2( UnpackDownscale, 1.0 / PackFactors.g );
const vec3 UnpackFactors3 = vec3( UnpackDownscale / PackFactors.rg, 1.0 / PackFactors.b );
const vec4 UnpackFactors4 = vec4( UnpackDownscale / PackFactors.rgb, 1.0 / PackFactors.a );
vec4 packDepthToRGBA( const in float v ) {
	if( v <= 0.0 )
		return vec4( 0., 0., 0., 0. );
	if( v >= 1.0 )
		return vec4( 1., 1., 1., 1. );
	float vuf;
	float af = modf( v * PackFactors.a, vuf );
	float bf = modf( vuf * ShiftRight8, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec4( vuf * Inv255, gf * PackUpscale, bf * PackUpscale, af );
}
vec3 packDepthToRGB( const in float v ) {
	if( v <= 0.0 )
		return vec3( 0., 0., 0. );
	if( v >= 1.0 )
		return vec3( 1., 1., 1. );
	float vuf;
	float bf = modf( v * PackFactors.b, vuf );
	float gf = modf( vuf * ShiftRight8, vuf );
	return vec3( vuf * Inv255, gf * PackUpscale, bf );
}
vec2 packDepthToRG( const in float v ) {
	if( v <= 0.0 )
		return vec2( 0., 0. );
	if( v >= 1.0 )
		return vec2( 1., 1. );
	float vuf;
	float gf = modf( v * 256., vuf );
	return vec2( vuf * Inv255, gf );
}
float unpackRGBAToDepth( const in vec4 v ) {
	return dot( v, UnpackFactors4 );
}
float unpackRGBToDepth( const in vec3 v ) {
	return dot( v, UnpackFactors3 );
}
float unpackRGToDepth( const in vec2 v ) {
	return v.r * UnpackFactors2.r + v.g * UnpackFactors2.g;
}
vec4 pack2HalfToRGBA( const in vec2 v ) {
	vec4 r = vec4( v.x, fract( v.x * 255.0 ), v.y, fract( v.y * 255.0 ) );
	return vec4( r.x - r.y / 255.0, r.y, r.z - r.w / 255.0, r.w );
}
vec2 unpackRGBATo2Half( const in vec4 v ) {
	return vec2( v.x + ( v.y / 255.0 ), v.z + ( v.w / 255.0 ) );
}
float viewZToOrthographicDepth( const in float viewZ, const in float near, const in float far ) {
	return ( viewZ + near ) / ( near - far );
}
float orthographicDepthToViewZ( const in float depth, const in float near, const in float far ) {
	#ifdef USE_REVERSED_DEPTH_BUFFER
	
		return depth * ( far - near ) - far;
	#else
		return depth * ( near - far ) - near;
	#endif
}
float viewZToPerspectiveDepth( const in float viewZ, const in float near, const in float far ) {
	return ( ( near + viewZ ) * far ) / ( ( far - near ) * viewZ );
}
float perspectiveDepthToViewZ( const in float depth, const in float near, const in float far ) {
	
	#ifdef USE_REVERSED_DEPTH_BUFFER
		return ( near * far ) / ( ( near - far ) * depth - near );
	#else
		return ( near * far ) / ( ( far - near ) * depth - far );
	#endif
}`,R_=`#ifdef PREMULTIPLIED_ALPHA
	gl_FragColor.rgb *= gl_FragColor.a;
#endif`,C_=`vec4 mvPosition = vec4( transformed, 1.0 );
#ifdef USE_BATCHING
	mvPosition = batchingMatrix * mvPosition;
#endif
#ifdef USE_INSTANCING
	mvPosition = instanceMatrix * mvPosition;
#endif
mvPosition = modelViewMatrix * mvPosition;
gl_Position = projectionMatrix * mvPosition;`,P_=`#ifdef DITHERING
	gl_FragColor.rgb = dithering( gl_FragColor.rgb );
#endif`,I_=`#ifdef DITHERING
	vec3 dithering( vec3 color ) {
		float grid_position = rand( gl_FragCoord.xy );
		vec3 dither_shift_RGB = vec3( 0.25 / 255.0, -0.25 / 255.0, 0.25 / 255.0 );
		dither_shift_RGB = mix( 2.0 * dither_shift_RGB, -2.0 * dither_shift_RGB, grid_position );
		return color + dither_shift_RGB;
	}
#endif`,L_=`float roughnessFactor = roughness;
#ifdef USE_ROUGHNESSMAP
	vec4 texelRoughness = texture2D( roughnessMap, vRoughnessMapUv );
	roughnessFactor *= texelRoughness.g;
#endif`,N_=`#ifdef USE_ROUGHNESSMAP
	uniform sampler2D roughnessMap;
#endif`,D_=`#if NUM_SPOT_LIGHT_COORDS > 0
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#if NUM_SPOT_LIGHT_MAPS > 0
	uniform sampler2D spotLightMap[ NUM_SPOT_LIGHT_MAPS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		#define SUN_LIGHT_CASCADES 2
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#else
			uniform sampler2D sunShadowMap[ NUM_SUN_LIGHT_SHADOWS ];
		#endif
		uniform mat4 sunShadowMatrix[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		uniform vec4 sunShadowCascade[ NUM_SUN_LIGHT_SHADOWS * SUN_LIGHT_CASCADES ];
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
		struct SunLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SunLightShadow sunLightShadows[ NUM_SUN_LIGHT_SHADOWS ];
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#else
			uniform sampler2D directionalShadowMap[ NUM_DIR_LIGHT_SHADOWS ];
		#endif
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform sampler2DShadow spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#else
			uniform sampler2D spotShadowMap[ NUM_SPOT_LIGHT_SHADOWS ];
		#endif
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#if defined( SHADOWMAP_TYPE_PCF )
			uniform samplerCubeShadow pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#elif defined( SHADOWMAP_TYPE_BASIC )
			uniform samplerCube pointShadowMap[ NUM_POINT_LIGHT_SHADOWS ];
		#endif
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float interleavedGradientNoise( vec2 position ) {
			return fract( 52.9829189 * fract( dot( position, vec2( 0.06711056, 0.00583715 ) ) ) );
		}
		vec2 vogelDiskSample( int sampleIndex, int samplesCount, float phi ) {
			const float goldenAngle = 2.399963229728653;
			float r = sqrt( ( float( sampleIndex ) + 0.5 ) / float( samplesCount ) );
			float theta = float( sampleIndex ) * goldenAngle + phi;
			return vec2( cos( theta ), sin( theta ) ) * r;
		}
	#endif
	#if defined( SHADOWMAP_TYPE_PCF )
		float getShadow( sampler2DShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 texelSize = vec2( 1.0 ) / shadowMapSize;
				vec2 radius = shadowRadius * texelSize;
				float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
				shadow = (
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 0, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 1, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 2, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 3, 5, phi ) * radius, shadowCoord.z ) ) +
					texture( shadowMap, vec3( shadowCoord.xy + vogelDiskSample( 4, 5, phi ) * radius, shadowCoord.z ) )
				) * 0.2;
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#elif defined( SHADOWMAP_TYPE_VSM )
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				vec2 distribution = texture2D( shadowMap, shadowCoord.xy ).rg;
				float mean = distribution.x;
				float variance = distribution.y * distribution.y;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					float hard_shadow = step( mean, shadowCoord.z );
				#else
					float hard_shadow = step( shadowCoord.z, mean );
				#endif
				
				if ( hard_shadow == 1.0 ) {
					shadow = 1.0;
				} else {
					variance = max( variance, 0.0000001 );
					float d = shadowCoord.z - mean;
					float p_max = variance / ( variance + d * d );
					p_max = clamp( ( p_max - 0.3 ) / 0.65, 0.0, 1.0 );
					shadow = max( hard_shadow, p_max );
				}
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#else
		float getShadow( sampler2D shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord ) {
			float shadow = 1.0;
			shadowCoord.xyz /= shadowCoord.w;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				shadowCoord.z -= shadowBias;
			#else
				shadowCoord.z += shadowBias;
			#endif
			bool inFrustum = shadowCoord.x >= 0.0 && shadowCoord.x <= 1.0 && shadowCoord.y >= 0.0 && shadowCoord.y <= 1.0;
			bool frustumTest = inFrustum && shadowCoord.z <= 1.0;
			if ( frustumTest ) {
				float depth = texture2D( shadowMap, shadowCoord.xy ).r;
				#ifdef USE_REVERSED_DEPTH_BUFFER
					shadow = step( depth, shadowCoord.z );
				#else
					shadow = step( shadowCoord.z, depth );
				#endif
			}
			return mix( 1.0, shadow, shadowIntensity );
		}
	#endif
	#if NUM_SUN_LIGHT_SHADOWS > 0
		float getSunShadow(
			#if defined( SHADOWMAP_TYPE_PCF )
				sampler2DShadow shadowMap,
			#else
				sampler2D shadowMap,
			#endif
			SunLightShadow sunLightShadow,
			int shadowIndex
		) {
			vec4 shadowWorldPosition = vec4( vSunShadowWorldPosition.xyz + vSunShadowWorldNormal * sunLightShadow.shadowNormalBias, 1.0 );
			float viewDepth = vSunShadowWorldPosition.w;
			int cascadeOffset = shadowIndex * SUN_LIGHT_CASCADES;
			float shadow = 1.0;
			for ( int i = SUN_LIGHT_CASCADES - 1; i >= 0; i -- ) {
				vec4 cascade = sunShadowCascade[ cascadeOffset + i ];
				if ( viewDepth >= cascade.x && viewDepth < cascade.y ) {
					float cascadeShadow = getShadow(
						shadowMap,
						sunLightShadow.shadowMapSize,
						sunLightShadow.shadowIntensity,
						sunLightShadow.shadowBias,
						sunLightShadow.shadowRadius,
						sunShadowMatrix[ cascadeOffset + i ] * shadowWorldPosition
					);
					shadow = mix( cascadeShadow, shadow, smoothstep( cascade.z, cascade.y, viewDepth ) );
				}
			}
			return shadow;
		}
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
	#if defined( SHADOWMAP_TYPE_PCF )
	float getPointShadow( samplerCubeShadow shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 bd3D = normalize( lightToPosition );
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float lightDistance = length( lightToPosition );
			float depthRange = shadowCameraFar - shadowCameraNear;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				float depthA = - shadowCameraNear / depthRange - shadowBias;
				float depthB = shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#else
				float depthA = shadowCameraFar / depthRange + shadowBias;
				float depthB = - shadowCameraNear * shadowCameraFar / ( depthRange * lightDistance );
			#endif
			float texelSize = shadowRadius / shadowMapSize.x;
			vec3 absDir = abs( bd3D );
			vec3 tangent = absDir.x > absDir.z ? vec3( 0.0, 1.0, 0.0 ) : vec3( 1.0, 0.0, 0.0 );
			tangent = normalize( cross( bd3D, tangent ) );
			vec3 bitangent = cross( bd3D, tangent );
			float phi = interleavedGradientNoise( gl_FragCoord.xy ) * PI2;
			shadow = 0.0;
			for ( int i = 0; i < 5; i ++ ) {
				vec2 offset = vogelDiskSample( i, 5, phi );
				vec3 direction = bd3D + ( tangent * offset.x + bitangent * offset.y ) * texelSize;
				vec3 absDirection = abs( direction );
				float dp = depthA + depthB / max( max( absDirection.x, absDirection.y ), absDirection.z );
				shadow += texture( shadowMap, vec4( direction, dp ) );
			}
			shadow *= 0.2;
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#elif defined( SHADOWMAP_TYPE_BASIC )
	float getPointShadow( samplerCube shadowMap, vec2 shadowMapSize, float shadowIntensity, float shadowBias, float shadowRadius, vec4 shadowCoord, float shadowCameraNear, float shadowCameraFar ) {
		float shadow = 1.0;
		vec3 lightToPosition = shadowCoord.xyz;
		vec3 absVec = abs( lightToPosition );
		float viewSpaceZ = max( max( absVec.x, absVec.y ), absVec.z );
		if ( viewSpaceZ - shadowCameraFar <= 0.0 && viewSpaceZ - shadowCameraNear >= 0.0 ) {
			float dp = ( shadowCameraFar * ( viewSpaceZ - shadowCameraNear ) ) / ( viewSpaceZ * ( shadowCameraFar - shadowCameraNear ) );
			dp += shadowBias;
			vec3 bd3D = normalize( lightToPosition );
			float depth = textureCube( shadowMap, bd3D ).r;
			#ifdef USE_REVERSED_DEPTH_BUFFER
				depth = 1.0 - depth;
			#endif
			shadow = step( dp, depth );
		}
		return mix( 1.0, shadow, shadowIntensity );
	}
	#endif
	#endif
#endif`,U_=`#if NUM_SPOT_LIGHT_COORDS > 0
	uniform mat4 spotLightMatrix[ NUM_SPOT_LIGHT_COORDS ];
	varying vec4 vSpotLightCoord[ NUM_SPOT_LIGHT_COORDS ];
#endif
#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
		varying vec4 vSunShadowWorldPosition;
		varying vec3 vSunShadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		uniform mat4 directionalShadowMatrix[ NUM_DIR_LIGHT_SHADOWS ];
		varying vec4 vDirectionalShadowCoord[ NUM_DIR_LIGHT_SHADOWS ];
		struct DirectionalLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform DirectionalLightShadow directionalLightShadows[ NUM_DIR_LIGHT_SHADOWS ];
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
		struct SpotLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
		};
		uniform SpotLightShadow spotLightShadows[ NUM_SPOT_LIGHT_SHADOWS ];
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		uniform mat4 pointShadowMatrix[ NUM_POINT_LIGHT_SHADOWS ];
		varying vec4 vPointShadowCoord[ NUM_POINT_LIGHT_SHADOWS ];
		struct PointLightShadow {
			float shadowIntensity;
			float shadowBias;
			float shadowNormalBias;
			float shadowRadius;
			vec2 shadowMapSize;
			float shadowCameraNear;
			float shadowCameraFar;
		};
		uniform PointLightShadow pointLightShadows[ NUM_POINT_LIGHT_SHADOWS ];
	#endif
#endif`,O_=`#if ( defined( USE_SHADOWMAP ) && ( NUM_DIR_LIGHT_SHADOWS > 0 || NUM_SUN_LIGHT_SHADOWS > 0 || NUM_POINT_LIGHT_SHADOWS > 0 ) ) || ( NUM_SPOT_LIGHT_COORDS > 0 )
	#ifdef HAS_NORMAL
		vec3 shadowWorldNormal = transformNormalByInverseViewMatrix( transformedNormal, viewMatrix );
	#else
		vec3 shadowWorldNormal = vec3( 0.0 );
	#endif
	vec4 shadowWorldPosition;
#endif
#if defined( USE_SHADOWMAP )
	#if NUM_SUN_LIGHT_SHADOWS > 0
		vSunShadowWorldPosition = vec4( worldPosition.xyz, - mvPosition.z );
		vSunShadowWorldNormal = shadowWorldNormal;
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * directionalLightShadows[ i ].shadowNormalBias, 0 );
			vDirectionalShadowCoord[ i ] = directionalShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0
		#pragma unroll_loop_start
		for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
			shadowWorldPosition = worldPosition + vec4( shadowWorldNormal * pointLightShadows[ i ].shadowNormalBias, 0 );
			vPointShadowCoord[ i ] = pointShadowMatrix[ i ] * shadowWorldPosition;
		}
		#pragma unroll_loop_end
	#endif
#endif
#if NUM_SPOT_LIGHT_COORDS > 0
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_COORDS; i ++ ) {
		shadowWorldPosition = worldPosition;
		#if ( defined( USE_SHADOWMAP ) && UNROLLED_LOOP_INDEX < NUM_SPOT_LIGHT_SHADOWS )
			shadowWorldPosition.xyz += shadowWorldNormal * spotLightShadows[ i ].shadowNormalBias;
		#endif
		vSpotLightCoord[ i ] = spotLightMatrix[ i ] * shadowWorldPosition;
	}
	#pragma unroll_loop_end
#endif`,F_=`float getShadowMask() {
	float shadow = 1.0;
	#ifdef USE_SHADOWMAP
	#if NUM_SUN_LIGHT_SHADOWS > 0
	SunLightShadow sunLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SUN_LIGHT_SHADOWS; i ++ ) {
		sunLight = sunLightShadows[ i ];
		shadow *= receiveShadow ? getSunShadow( sunShadowMap[ i ], sunLight, UNROLLED_LOOP_INDEX ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_DIR_LIGHT_SHADOWS > 0
	DirectionalLightShadow directionalLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_DIR_LIGHT_SHADOWS; i ++ ) {
		directionalLight = directionalLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( directionalShadowMap[ i ], directionalLight.shadowMapSize, directionalLight.shadowIntensity, directionalLight.shadowBias, directionalLight.shadowRadius, vDirectionalShadowCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_SPOT_LIGHT_SHADOWS > 0
	SpotLightShadow spotLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_SPOT_LIGHT_SHADOWS; i ++ ) {
		spotLight = spotLightShadows[ i ];
		shadow *= receiveShadow ? getShadow( spotShadowMap[ i ], spotLight.shadowMapSize, spotLight.shadowIntensity, spotLight.shadowBias, spotLight.shadowRadius, vSpotLightCoord[ i ] ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#if NUM_POINT_LIGHT_SHADOWS > 0 && ( defined( SHADOWMAP_TYPE_PCF ) || defined( SHADOWMAP_TYPE_BASIC ) )
	PointLightShadow pointLight;
	#pragma unroll_loop_start
	for ( int i = 0; i < NUM_POINT_LIGHT_SHADOWS; i ++ ) {
		pointLight = pointLightShadows[ i ];
		shadow *= receiveShadow ? getPointShadow( pointShadowMap[ i ], pointLight.shadowMapSize, pointLight.shadowIntensity, pointLight.shadowBias, pointLight.shadowRadius, vPointShadowCoord[ i ], pointLight.shadowCameraNear, pointLight.shadowCameraFar ) : 1.0;
	}
	#pragma unroll_loop_end
	#endif
	#endif
	return shadow;
}`,B_=`#ifdef USE_SKINNING
	mat4 boneMatX = getBoneMatrix( skinIndex.x );
	mat4 boneMatY = getBoneMatrix( skinIndex.y );
	mat4 boneMatZ = getBoneMatrix( skinIndex.z );
	mat4 boneMatW = getBoneMatrix( skinIndex.w );
#endif`,z_=`#ifdef USE_SKINNING
	uniform mat4 bindMatrix;
	uniform mat4 bindMatrixInverse;
	uniform highp sampler2D boneTexture;
	mat4 getBoneMatrix( const in float i ) {
		int size = textureSize( boneTexture, 0 ).x;
		int j = int( i ) * 4;
		int x = j % size;
		int y = j / size;
		vec4 v1 = texelFetch( boneTexture, ivec2( x, y ), 0 );
		vec4 v2 = texelFetch( boneTexture, ivec2( x + 1, y ), 0 );
		vec4 v3 = texelFetch( boneTexture, ivec2( x + 2, y ), 0 );
		vec4 v4 = texelFetch( boneTexture, ivec2( x + 3, y ), 0 );
		return mat4( v1, v2, v3, v4 );
	}
#endif`,k_=`#ifdef USE_SKINNING
	vec4 skinVertex = bindMatrix * vec4( transformed, 1.0 );
	vec4 skinned = vec4( 0.0 );
	skinned += boneMatX * skinVertex * skinWeight.x;
	skinned += boneMatY * skinVertex * skinWeight.y;
	skinned += boneMatZ * skinVertex * skinWeight.z;
	skinned += boneMatW * skinVertex * skinWeight.w;
	transformed = ( bindMatrixInverse * skinned ).xyz;
#endif`,G_=`#ifdef USE_SKINNING
	mat4 skinMatrix = mat4( 0.0 );
	skinMatrix += skinWeight.x * boneMatX;
	skinMatrix += skinWeight.y * boneMatY;
	skinMatrix += skinWeight.z * boneMatZ;
	skinMatrix += skinWeight.w * boneMatW;
	skinMatrix = bindMatrixInverse * skinMatrix * bindMatrix;
	objectNormal = vec4( skinMatrix * vec4( objectNormal, 0.0 ) ).xyz;
	#ifdef USE_TANGENT
		objectTangent = vec4( skinMatrix * vec4( objectTangent, 0.0 ) ).xyz;
	#endif
#endif`,V_=`float specularStrength;
#ifdef USE_SPECULARMAP
	vec4 texelSpecular = texture2D( specularMap, vSpecularMapUv );
	specularStrength = texelSpecular.r;
#else
	specularStrength = 1.0;
#endif`,H_=`#ifdef USE_SPECULARMAP
	uniform sampler2D specularMap;
#endif`,W_=`#if defined( TONE_MAPPING )
	gl_FragColor.rgb = toneMapping( gl_FragColor.rgb );
#endif`,q_=`#ifndef saturate
#define saturate( a ) clamp( a, 0.0, 1.0 )
#endif
uniform float toneMappingExposure;
vec3 LinearToneMapping( vec3 color ) {
	return saturate( toneMappingExposure * color );
}
vec3 ReinhardToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	return saturate( color / ( vec3( 1.0 ) + color ) );
}
vec3 CineonToneMapping( vec3 color ) {
	color *= toneMappingExposure;
	color = max( vec3( 0.0 ), color - 0.004 );
	return pow( ( color * ( 6.2 * color + 0.5 ) ) / ( color * ( 6.2 * color + 1.7 ) + 0.06 ), vec3( 2.2 ) );
}
vec3 RRTAndODTFit( vec3 v ) {
	vec3 a = v * ( v + 0.0245786 ) - 0.000090537;
	vec3 b = v * ( 0.983729 * v + 0.4329510 ) + 0.238081;
	return a / b;
}
vec3 ACESFilmicToneMapping( vec3 color ) {
	const mat3 ACESInputMat = mat3(
		vec3( 0.59719, 0.07600, 0.02840 ),		vec3( 0.35458, 0.90834, 0.13383 ),
		vec3( 0.04823, 0.01566, 0.83777 )
	);
	const mat3 ACESOutputMat = mat3(
		vec3(  1.60475, -0.10208, -0.00327 ),		vec3( -0.53108,  1.10813, -0.07276 ),
		vec3( -0.07367, -0.00605,  1.07602 )
	);
	color *= toneMappingExposure / 0.6;
	color = ACESInputMat * color;
	color = RRTAndODTFit( color );
	color = ACESOutputMat * color;
	return saturate( color );
}
const mat3 LINEAR_REC2020_TO_LINEAR_SRGB = mat3(
	vec3( 1.6605, - 0.1246, - 0.0182 ),
	vec3( - 0.5876, 1.1329, - 0.1006 ),
	vec3( - 0.0728, - 0.0083, 1.1187 )
);
const mat3 LINEAR_SRGB_TO_LINEAR_REC2020 = mat3(
	vec3( 0.6274, 0.0691, 0.0164 ),
	vec3( 0.3293, 0.9195, 0.0880 ),
	vec3( 0.0433, 0.0113, 0.8956 )
);
vec3 agxDefaultContrastApprox( vec3 x ) {
	vec3 x2 = x * x;
	vec3 x4 = x2 * x2;
	return + 15.5 * x4 * x2
		- 40.14 * x4 * x
		+ 31.96 * x4
		- 6.868 * x2 * x
		+ 0.4298 * x2
		+ 0.1191 * x
		- 0.00232;
}
vec3 AgXToneMapping( vec3 color ) {
	const mat3 AgXInsetMatrix = mat3(
		vec3( 0.856627153315983, 0.137318972929847, 0.11189821299995 ),
		vec3( 0.0951212405381588, 0.761241990602591, 0.0767994186031903 ),
		vec3( 0.0482516061458583, 0.101439036467562, 0.811302368396859 )
	);
	const mat3 AgXOutsetMatrix = mat3(
		vec3( 1.1271005818144368, - 0.1413297634984383, - 0.14132976349843826 ),
		vec3( - 0.11060664309660323, 1.157823702216272, - 0.11060664309660294 ),
		vec3( - 0.016493938717834573, - 0.016493938717834257, 1.2519364065950405 )
	);
	const float AgxMinEv = - 12.47393;	const float AgxMaxEv = 4.026069;
	color *= toneMappingExposure;
	color = LINEAR_SRGB_TO_LINEAR_REC2020 * color;
	color = AgXInsetMatrix * color;
	color = max( color, 1e-10 );	color = log2( color );
	color = ( color - AgxMinEv ) / ( AgxMaxEv - AgxMinEv );
	color = clamp( color, 0.0, 1.0 );
	color = agxDefaultContrastApprox( color );
	color = AgXOutsetMatrix * color;
	color = pow( max( vec3( 0.0 ), color ), vec3( 2.2 ) );
	color = LINEAR_REC2020_TO_LINEAR_SRGB * color;
	color = clamp( color, 0.0, 1.0 );
	return color;
}
vec3 NeutralToneMapping( vec3 color ) {
	const float StartCompression = 0.8 - 0.04;
	const float Desaturation = 0.15;
	color *= toneMappingExposure;
	float x = min( color.r, min( color.g, color.b ) );
	float offset = x < 0.08 ? x - 6.25 * x * x : 0.04;
	color -= offset;
	float peak = max( color.r, max( color.g, color.b ) );
	if ( peak < StartCompression ) return color;
	float d = 1. - StartCompression;
	float newPeak = 1. - d * d / ( peak + d - StartCompression );
	color *= newPeak / peak;
	float g = 1. - 1. / ( Desaturation * ( peak - newPeak ) + 1. );
	return mix( color, vec3( newPeak ), g );
}
vec3 CustomToneMapping( vec3 color ) { return color; }`,X_=`#ifdef USE_TRANSMISSION
	material.transmission = transmission;
	material.transmissionAlpha = 1.0;
	material.thickness = thickness;
	material.attenuationDistance = attenuationDistance;
	material.attenuationColor = attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		material.transmission *= texture2D( transmissionMap, vTransmissionMapUv ).r;
	#endif
	#ifdef USE_THICKNESSMAP
		material.thickness *= texture2D( thicknessMap, vThicknessMapUv ).g;
	#endif
	vec3 pos = vWorldPosition;
	vec3 v = normalize( cameraPosition - pos );
	vec3 n = transformNormalByInverseViewMatrix( normal, viewMatrix );
	vec4 transmitted = getIBLVolumeRefraction(
		n, v, material.roughness, material.diffuseContribution, material.specularColorBlended, material.specularF90,
		pos, modelMatrix, viewMatrix, projectionMatrix, material.dispersion, material.ior, material.thickness,
		material.attenuationColor, material.attenuationDistance );
	material.transmissionAlpha = mix( material.transmissionAlpha, transmitted.a, material.transmission );
	totalDiffuse = mix( totalDiffuse, transmitted.rgb, material.transmission );
#endif`,$_=`#ifdef USE_TRANSMISSION
	uniform float transmission;
	uniform float thickness;
	uniform float attenuationDistance;
	uniform vec3 attenuationColor;
	#ifdef USE_TRANSMISSIONMAP
		uniform sampler2D transmissionMap;
	#endif
	#ifdef USE_THICKNESSMAP
		uniform sampler2D thicknessMap;
	#endif
	uniform vec2 transmissionSamplerSize;
	uniform sampler2D transmissionSamplerMap;
	uniform mat4 modelMatrix;
	uniform mat4 projectionMatrix;
	varying vec3 vWorldPosition;
	float w0( float a ) {
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - a + 3.0 ) - 3.0 ) + 1.0 );
	}
	float w1( float a ) {
		return ( 1.0 / 6.0 ) * ( a *  a * ( 3.0 * a - 6.0 ) + 4.0 );
	}
	float w2( float a ){
		return ( 1.0 / 6.0 ) * ( a * ( a * ( - 3.0 * a + 3.0 ) + 3.0 ) + 1.0 );
	}
	float w3( float a ) {
		return ( 1.0 / 6.0 ) * ( a * a * a );
	}
	float g0( float a ) {
		return w0( a ) + w1( a );
	}
	float g1( float a ) {
		return w2( a ) + w3( a );
	}
	float h0( float a ) {
		return - 1.0 + w1( a ) / ( w0( a ) + w1( a ) );
	}
	float h1( float a ) {
		return 1.0 + w3( a ) / ( w2( a ) + w3( a ) );
	}
	vec4 bicubic( sampler2D tex, vec2 uv, vec4 texelSize, float lod ) {
		uv = uv * texelSize.zw + 0.5;
		vec2 iuv = floor( uv );
		vec2 fuv = fract( uv );
		float g0x = g0( fuv.x );
		float g1x = g1( fuv.x );
		float h0x = h0( fuv.x );
		float h1x = h1( fuv.x );
		float h0y = h0( fuv.y );
		float h1y = h1( fuv.y );
		vec2 p0 = ( vec2( iuv.x + h0x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p1 = ( vec2( iuv.x + h1x, iuv.y + h0y ) - 0.5 ) * texelSize.xy;
		vec2 p2 = ( vec2( iuv.x + h0x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		vec2 p3 = ( vec2( iuv.x + h1x, iuv.y + h1y ) - 0.5 ) * texelSize.xy;
		return g0( fuv.y ) * ( g0x * textureLod( tex, p0, lod ) + g1x * textureLod( tex, p1, lod ) ) +
			g1( fuv.y ) * ( g0x * textureLod( tex, p2, lod ) + g1x * textureLod( tex, p3, lod ) );
	}
	vec4 textureBicubic( sampler2D sampler, vec2 uv, float lod ) {
		vec2 fLodSize = vec2( textureSize( sampler, int( lod ) ) );
		vec2 cLodSize = vec2( textureSize( sampler, int( lod + 1.0 ) ) );
		vec2 fLodSizeInv = 1.0 / fLodSize;
		vec2 cLodSizeInv = 1.0 / cLodSize;
		vec4 fSample = bicubic( sampler, uv, vec4( fLodSizeInv, fLodSize ), floor( lod ) );
		vec4 cSample = bicubic( sampler, uv, vec4( cLodSizeInv, cLodSize ), ceil( lod ) );
		return mix( fSample, cSample, fract( lod ) );
	}
	vec3 getVolumeTransmissionRay( const in vec3 n, const in vec3 v, const in float thickness, const in float ior, const in mat4 modelMatrix ) {
		vec3 refractionVector = refract( - v, normalize( n ), 1.0 / ior );
		vec3 modelScale;
		modelScale.x = length( vec3( modelMatrix[ 0 ].xyz ) );
		modelScale.y = length( vec3( modelMatrix[ 1 ].xyz ) );
		modelScale.z = length( vec3( modelMatrix[ 2 ].xyz ) );
		return normalize( refractionVector ) * thickness * modelScale;
	}
	float applyIorToRoughness( const in float roughness, const in float ior ) {
		return roughness * clamp( ior * 2.0 - 2.0, 0.0, 1.0 );
	}
	vec4 getTransmissionSample( const in vec2 fragCoord, const in float roughness, const in float ior ) {
		float lod = log2( transmissionSamplerSize.x ) * applyIorToRoughness( roughness, ior );
		return textureBicubic( transmissionSamplerMap, fragCoord.xy, lod );
	}
	vec3 volumeAttenuation( const in float transmissionDistance, const in vec3 attenuationColor, const in float attenuationDistance ) {
		if ( isinf( attenuationDistance ) ) {
			return vec3( 1.0 );
		} else {
			vec3 attenuationCoefficient = -log( attenuationColor ) / attenuationDistance;
			vec3 transmittance = exp( - attenuationCoefficient * transmissionDistance );			return transmittance;
		}
	}
	vec4 getIBLVolumeRefraction( const in vec3 n, const in vec3 v, const in float roughness, const in vec3 diffuseColor,
		const in vec3 specularColor, const in float specularF90, const in vec3 position, const in mat4 modelMatrix,
		const in mat4 viewMatrix, const in mat4 projMatrix, const in float dispersion, const in float ior, const in float thickness,
		const in vec3 attenuationColor, const in float attenuationDistance ) {
		vec4 transmittedLight;
		vec3 transmittance;
		#ifdef USE_DISPERSION
			float halfSpread = ( ior - 1.0 ) * 0.025 * dispersion;
			vec3 iors = vec3( ior - halfSpread, ior, ior + halfSpread );
			for ( int i = 0; i < 3; i ++ ) {
				vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, iors[ i ], modelMatrix );
				vec3 refractedRayExit = position + transmissionRay;
				vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
				vec2 refractionCoords = ndcPos.xy / ndcPos.w;
				refractionCoords += 1.0;
				refractionCoords /= 2.0;
				vec4 transmissionSample = getTransmissionSample( refractionCoords, roughness, iors[ i ] );
				transmittedLight[ i ] = transmissionSample[ i ];
				transmittedLight.a += transmissionSample.a;
				transmittance[ i ] = diffuseColor[ i ] * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance )[ i ];
			}
			transmittedLight.a /= 3.0;
		#else
			vec3 transmissionRay = getVolumeTransmissionRay( n, v, thickness, ior, modelMatrix );
			vec3 refractedRayExit = position + transmissionRay;
			vec4 ndcPos = projMatrix * viewMatrix * vec4( refractedRayExit, 1.0 );
			vec2 refractionCoords = ndcPos.xy / ndcPos.w;
			refractionCoords += 1.0;
			refractionCoords /= 2.0;
			transmittedLight = getTransmissionSample( refractionCoords, roughness, ior );
			transmittance = diffuseColor * volumeAttenuation( length( transmissionRay ), attenuationColor, attenuationDistance );
		#endif
		vec3 attenuatedColor = transmittance * transmittedLight.rgb;
		vec3 F = EnvironmentBRDF( n, v, specularColor, specularF90, roughness );
		float transmittanceFactor = ( transmittance.r + transmittance.g + transmittance.b ) / 3.0;
		return vec4( ( 1.0 - F ) * attenuatedColor, 1.0 - ( 1.0 - transmittedLight.a ) * transmittanceFactor );
	}
#endif`,Y_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_SPECULARMAP
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,Z_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	varying vec2 vUv;
#endif
#ifdef USE_MAP
	uniform mat3 mapTransform;
	varying vec2 vMapUv;
#endif
#ifdef USE_ALPHAMAP
	uniform mat3 alphaMapTransform;
	varying vec2 vAlphaMapUv;
#endif
#ifdef USE_LIGHTMAP
	uniform mat3 lightMapTransform;
	varying vec2 vLightMapUv;
#endif
#ifdef USE_AOMAP
	uniform mat3 aoMapTransform;
	varying vec2 vAoMapUv;
#endif
#ifdef USE_BUMPMAP
	uniform mat3 bumpMapTransform;
	varying vec2 vBumpMapUv;
#endif
#ifdef USE_NORMALMAP
	uniform mat3 normalMapTransform;
	varying vec2 vNormalMapUv;
#endif
#ifdef USE_DISPLACEMENTMAP
	uniform mat3 displacementMapTransform;
	varying vec2 vDisplacementMapUv;
#endif
#ifdef USE_EMISSIVEMAP
	uniform mat3 emissiveMapTransform;
	varying vec2 vEmissiveMapUv;
#endif
#ifdef USE_METALNESSMAP
	uniform mat3 metalnessMapTransform;
	varying vec2 vMetalnessMapUv;
#endif
#ifdef USE_ROUGHNESSMAP
	uniform mat3 roughnessMapTransform;
	varying vec2 vRoughnessMapUv;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	uniform mat3 diffuseRoughnessMapTransform;
	varying vec2 vDiffuseRoughnessMapUv;
#endif
#ifdef USE_ANISOTROPYMAP
	uniform mat3 anisotropyMapTransform;
	varying vec2 vAnisotropyMapUv;
#endif
#ifdef USE_CLEARCOATMAP
	uniform mat3 clearcoatMapTransform;
	varying vec2 vClearcoatMapUv;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	uniform mat3 clearcoatNormalMapTransform;
	varying vec2 vClearcoatNormalMapUv;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	uniform mat3 clearcoatRoughnessMapTransform;
	varying vec2 vClearcoatRoughnessMapUv;
#endif
#ifdef USE_SHEEN_COLORMAP
	uniform mat3 sheenColorMapTransform;
	varying vec2 vSheenColorMapUv;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	uniform mat3 sheenRoughnessMapTransform;
	varying vec2 vSheenRoughnessMapUv;
#endif
#ifdef USE_IRIDESCENCEMAP
	uniform mat3 iridescenceMapTransform;
	varying vec2 vIridescenceMapUv;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	uniform mat3 iridescenceThicknessMapTransform;
	varying vec2 vIridescenceThicknessMapUv;
#endif
#ifdef USE_SPECULARMAP
	uniform mat3 specularMapTransform;
	varying vec2 vSpecularMapUv;
#endif
#ifdef USE_SPECULAR_COLORMAP
	uniform mat3 specularColorMapTransform;
	varying vec2 vSpecularColorMapUv;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	uniform mat3 specularIntensityMapTransform;
	varying vec2 vSpecularIntensityMapUv;
#endif
#ifdef USE_TRANSMISSIONMAP
	uniform mat3 transmissionMapTransform;
	varying vec2 vTransmissionMapUv;
#endif
#ifdef USE_THICKNESSMAP
	uniform mat3 thicknessMapTransform;
	varying vec2 vThicknessMapUv;
#endif`,J_=`#if defined( USE_UV ) || defined( USE_ANISOTROPY )
	vUv = vec3( uv, 1 ).xy;
#endif
#ifdef USE_MAP
	vMapUv = ( mapTransform * vec3( MAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ALPHAMAP
	vAlphaMapUv = ( alphaMapTransform * vec3( ALPHAMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_LIGHTMAP
	vLightMapUv = ( lightMapTransform * vec3( LIGHTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_AOMAP
	vAoMapUv = ( aoMapTransform * vec3( AOMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_BUMPMAP
	vBumpMapUv = ( bumpMapTransform * vec3( BUMPMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_NORMALMAP
	vNormalMapUv = ( normalMapTransform * vec3( NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DISPLACEMENTMAP
	vDisplacementMapUv = ( displacementMapTransform * vec3( DISPLACEMENTMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_EMISSIVEMAP
	vEmissiveMapUv = ( emissiveMapTransform * vec3( EMISSIVEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_METALNESSMAP
	vMetalnessMapUv = ( metalnessMapTransform * vec3( METALNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ROUGHNESSMAP
	vRoughnessMapUv = ( roughnessMapTransform * vec3( ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_DIFFUSE_ROUGHNESSMAP
	vDiffuseRoughnessMapUv = ( diffuseRoughnessMapTransform * vec3( DIFFUSE_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_ANISOTROPYMAP
	vAnisotropyMapUv = ( anisotropyMapTransform * vec3( ANISOTROPYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOATMAP
	vClearcoatMapUv = ( clearcoatMapTransform * vec3( CLEARCOATMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_NORMALMAP
	vClearcoatNormalMapUv = ( clearcoatNormalMapTransform * vec3( CLEARCOAT_NORMALMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_CLEARCOAT_ROUGHNESSMAP
	vClearcoatRoughnessMapUv = ( clearcoatRoughnessMapTransform * vec3( CLEARCOAT_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCEMAP
	vIridescenceMapUv = ( iridescenceMapTransform * vec3( IRIDESCENCEMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_IRIDESCENCE_THICKNESSMAP
	vIridescenceThicknessMapUv = ( iridescenceThicknessMapTransform * vec3( IRIDESCENCE_THICKNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_COLORMAP
	vSheenColorMapUv = ( sheenColorMapTransform * vec3( SHEEN_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SHEEN_ROUGHNESSMAP
	vSheenRoughnessMapUv = ( sheenRoughnessMapTransform * vec3( SHEEN_ROUGHNESSMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULARMAP
	vSpecularMapUv = ( specularMapTransform * vec3( SPECULARMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_COLORMAP
	vSpecularColorMapUv = ( specularColorMapTransform * vec3( SPECULAR_COLORMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_SPECULAR_INTENSITYMAP
	vSpecularIntensityMapUv = ( specularIntensityMapTransform * vec3( SPECULAR_INTENSITYMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_TRANSMISSIONMAP
	vTransmissionMapUv = ( transmissionMapTransform * vec3( TRANSMISSIONMAP_UV, 1 ) ).xy;
#endif
#ifdef USE_THICKNESSMAP
	vThicknessMapUv = ( thicknessMapTransform * vec3( THICKNESSMAP_UV, 1 ) ).xy;
#endif`,K_=`#if defined( USE_ENVMAP ) || defined( DISTANCE ) || defined ( USE_SHADOWMAP ) || defined ( USE_TRANSMISSION ) || NUM_SPOT_LIGHT_COORDS > 0
	vec4 worldPosition = vec4( transformed, 1.0 );
	#ifdef USE_BATCHING
		worldPosition = batchingMatrix * worldPosition;
	#endif
	#ifdef USE_INSTANCING
		worldPosition = instanceMatrix * worldPosition;
	#endif
	worldPosition = modelMatrix * worldPosition;
#endif`,j_=`varying vec2 vUv;
uniform mat3 uvTransform;
void main() {
	vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	gl_Position = vec4( position.xy, 1.0, 1.0 );
}`,Q_=`uniform sampler2D t2D;
uniform float backgroundIntensity;
varying vec2 vUv;
void main() {
	vec4 texColor = texture2D( t2D, vUv );
	#ifdef DECODE_VIDEO_TEXTURE
		texColor = vec4( mix( pow( texColor.rgb * 0.9478672986 + vec3( 0.0521327014 ), vec3( 2.4 ) ), texColor.rgb * 0.0773993808, vec3( lessThanEqual( texColor.rgb, vec3( 0.04045 ) ) ) ), texColor.w );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ty=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,ey=`uniform float backgroundBlurriness;
uniform float backgroundIntensity;
uniform mat3 backgroundRotation;
varying vec3 vWorldDirection;
#include <envmap_common_pars_fragment>
void main() {
	#ifdef ENVMAP_TYPE_PMREM
		vec4 texColor = textureLod( envMap, backgroundRotation * vWorldDirection, roughnessToMip( backgroundBlurriness ) );
	#else
		vec4 texColor = textureCube( envMap, backgroundRotation * vWorldDirection );
	#endif
	texColor.rgb *= backgroundIntensity;
	gl_FragColor = texColor;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,ny=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
	gl_Position.z = gl_Position.w;
}`,iy=`uniform samplerCube tCube;
uniform float tFlip;
uniform float opacity;
varying vec3 vWorldDirection;
void main() {
	vec4 texColor = textureCube( tCube, vec3( tFlip * vWorldDirection.x, vWorldDirection.yz ) );
	gl_FragColor = texColor;
	gl_FragColor.a *= opacity;
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,sy=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
varying vec2 vHighPrecisionZW;
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vHighPrecisionZW = gl_Position.zw;
}`,ry=`#if DEPTH_PACKING == 3200
	uniform float opacity;
#endif
#include <common>
#include <packing>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
varying vec2 vHighPrecisionZW;
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#if DEPTH_PACKING == 3200
		diffuseColor.a = opacity;
	#endif
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <logdepthbuf_fragment>
	#ifdef USE_REVERSED_DEPTH_BUFFER
		float fragCoordZ = vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ];
	#else
		float fragCoordZ = 0.5 * vHighPrecisionZW[ 0 ] / vHighPrecisionZW[ 1 ] + 0.5;
	#endif
	#if DEPTH_PACKING == 3200
		gl_FragColor = vec4( vec3( 1.0 - fragCoordZ ), opacity );
	#elif DEPTH_PACKING == 3201
		gl_FragColor = packDepthToRGBA( fragCoordZ );
	#elif DEPTH_PACKING == 3202
		gl_FragColor = vec4( packDepthToRGB( fragCoordZ ), 1.0 );
	#elif DEPTH_PACKING == 3203
		gl_FragColor = vec4( packDepthToRG( fragCoordZ ), 0.0, 1.0 );
	#endif
}`,oy=`#define DISTANCE
varying vec3 vWorldPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <skinbase_vertex>
	#include <morphinstance_vertex>
	#ifdef USE_DISPLACEMENTMAP
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <worldpos_vertex>
	#include <clipping_planes_vertex>
	vWorldPosition = worldPosition.xyz;
}`,ay=`#define DISTANCE
uniform vec3 referencePosition;
uniform float nearDistance;
uniform float farDistance;
varying vec3 vWorldPosition;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 1.0 );
	#include <clipping_planes_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	float dist = length( vWorldPosition - referencePosition );
	dist = ( dist - nearDistance ) / ( farDistance - nearDistance );
	dist = saturate( dist );
	gl_FragColor = vec4( dist, 0.0, 0.0, 1.0 );
}`,cy=`varying vec3 vWorldDirection;
#include <common>
void main() {
	vWorldDirection = transformDirection( position, modelMatrix );
	#include <begin_vertex>
	#include <project_vertex>
}`,ly=`uniform sampler2D tEquirect;
varying vec3 vWorldDirection;
#include <common>
void main() {
	vec3 direction = normalize( vWorldDirection );
	vec2 sampleUV = equirectUv( direction );
	gl_FragColor = texture2D( tEquirect, sampleUV );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
}`,hy=`uniform float scale;
attribute float lineDistance;
varying float vLineDistance;
#include <common>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	vLineDistance = scale * lineDistance;
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,uy=`uniform vec3 diffuse;
uniform float opacity;
uniform float dashSize;
uniform float totalSize;
varying float vLineDistance;
#include <common>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	if ( mod( vLineDistance, totalSize ) > dashSize ) {
		discard;
	}
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,dy=`#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#if defined ( USE_ENVMAP ) || defined ( USE_SKINNING )
		#include <beginnormal_vertex>
		#include <morphnormal_vertex>
		#include <skinbase_vertex>
		#include <skinnormal_vertex>
		#include <defaultnormal_vertex>
	#endif
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <fog_vertex>
}`,fy=`uniform vec3 diffuse;
uniform float opacity;
#ifndef FLAT_SHADED
	varying vec3 vNormal;
#endif
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <fog_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	#ifdef USE_LIGHTMAP
		vec4 lightMapTexel = texture2D( lightMap, vLightMapUv );
		reflectedLight.indirectDiffuse += lightMapTexel.rgb * lightMapIntensity * RECIPROCAL_PI;
	#else
		reflectedLight.indirectDiffuse += vec3( 1.0 );
	#endif
	#include <aomap_fragment>
	reflectedLight.indirectDiffuse *= diffuseColor.rgb;
	vec3 outgoingLight = reflectedLight.indirectDiffuse;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,py=`#define LAMBERT
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,my=`#define LAMBERT
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_lambert_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_lambert_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,gy=`#define MATCAP
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <color_pars_vertex>
#include <displacementmap_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
	vViewPosition = - mvPosition.xyz;
}`,xy=`#define MATCAP
uniform vec3 diffuse;
uniform float opacity;
uniform sampler2D matcap;
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	vec3 viewDir = normalize( vViewPosition );
	vec3 x = normalize( vec3( viewDir.z, 0.0, - viewDir.x ) );
	vec3 y = cross( viewDir, x );
	vec2 uv = vec2( dot( x, normal ), dot( y, normal ) ) * 0.495 + 0.5;
	#ifdef USE_MATCAP
		vec4 matcapColor = texture2D( matcap, uv );
	#else
		vec4 matcapColor = vec4( vec3( mix( 0.2, 0.8, uv.y ) ), 1.0 );
	#endif
	vec3 outgoingLight = diffuseColor.rgb * matcapColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,_y=`#define NORMAL
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	vViewPosition = - mvPosition.xyz;
#endif
}`,yy=`#define NORMAL
uniform float opacity;
#if defined( FLAT_SHADED ) || defined( USE_BUMPMAP ) || defined( USE_NORMALMAP_TANGENTSPACE )
	varying vec3 vViewPosition;
#endif
#include <uv_pars_fragment>
#include <normal_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( 0.0, 0.0, 0.0, opacity );
	#include <clipping_planes_fragment>
	#include <logdepthbuf_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	gl_FragColor = vec4( normalize( normal ) * 0.5 + 0.5, diffuseColor.a );
	#ifdef OPAQUE
		gl_FragColor.a = 1.0;
	#endif
}`,vy=`#define PHONG
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <envmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <envmap_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,My=`#define PHONG
uniform vec3 diffuse;
uniform vec3 emissive;
uniform vec3 specular;
uniform float shininess;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_phong_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <specularmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <specularmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_phong_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + reflectedLight.directSpecular + reflectedLight.indirectSpecular + totalEmissiveRadiance;
	#include <envmap_fragment>
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Sy=`#define STANDARD
varying vec3 vViewPosition;
#ifdef USE_TRANSMISSION
	varying vec3 vWorldPosition;
#endif
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
#ifdef USE_TRANSMISSION
	vWorldPosition = worldPosition.xyz;
#endif
}`,by=`#define STANDARD
#ifdef PHYSICAL
	#define IOR
	#define USE_SPECULAR
#endif
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float roughness;
uniform float metalness;
uniform float opacity;
#ifdef IOR
	uniform float ior;
#endif
#ifdef USE_SPECULAR
	uniform float specularIntensity;
	uniform vec3 specularColor;
	#ifdef USE_SPECULAR_COLORMAP
		uniform sampler2D specularColorMap;
	#endif
	#ifdef USE_SPECULAR_INTENSITYMAP
		uniform sampler2D specularIntensityMap;
	#endif
#endif
#ifdef USE_CLEARCOAT
	uniform float clearcoat;
	uniform float clearcoatRoughness;
#endif
#ifdef USE_DIFFUSE_ROUGHNESS
	uniform float diffuseRoughness;
	#ifdef USE_DIFFUSE_ROUGHNESSMAP
		uniform sampler2D diffuseRoughnessMap;
	#endif
#endif
#ifdef USE_DISPERSION
	uniform float dispersion;
#endif
#ifdef USE_RETROREFLECTION
	uniform float retroreflectivity;
#endif
#ifdef USE_IRIDESCENCE
	uniform float iridescence;
	uniform float iridescenceIOR;
	uniform float iridescenceThicknessMinimum;
	uniform float iridescenceThicknessMaximum;
#endif
#ifdef USE_SHEEN
	uniform vec3 sheenColor;
	uniform float sheenRoughness;
	#ifdef USE_SHEEN_COLORMAP
		uniform sampler2D sheenColorMap;
	#endif
	#ifdef USE_SHEEN_ROUGHNESSMAP
		uniform sampler2D sheenRoughnessMap;
	#endif
#endif
#ifdef USE_ANISOTROPY
	uniform vec2 anisotropyVector;
	#ifdef USE_ANISOTROPYMAP
		uniform sampler2D anisotropyMap;
	#endif
#endif
varying vec3 vViewPosition;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <iridescence_fragment>
#include <envmap_common_pars_fragment>
#include <envmap_physical_pars_fragment>
#include <fog_pars_fragment>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_physical_pars_fragment>
#include <transmission_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <clearcoat_pars_fragment>
#include <iridescence_pars_fragment>
#include <roughnessmap_pars_fragment>
#include <metalnessmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <roughnessmap_fragment>
	#include <metalnessmap_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <clearcoat_normal_fragment_begin>
	#include <clearcoat_normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_physical_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 totalDiffuse = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse;
	vec3 totalSpecular = reflectedLight.directSpecular + reflectedLight.indirectSpecular;
	#include <transmission_fragment>
	vec3 outgoingLight = totalDiffuse + totalSpecular + totalEmissiveRadiance;
	#ifdef USE_SHEEN
 
		outgoingLight = outgoingLight + sheenSpecularDirect + sheenSpecularIndirect;
 
 	#endif
	#ifdef USE_CLEARCOAT
		float dotNVcc = saturate( dot( geometryClearcoatNormal, geometryViewDir ) );
		vec3 Fcc = F_Schlick( material.clearcoatF0, material.clearcoatF90, dotNVcc );
		outgoingLight = outgoingLight * ( 1.0 - material.clearcoat * Fcc ) + ( clearcoatSpecularDirect + clearcoatSpecularIndirect ) * material.clearcoat;
	#endif
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,wy=`#define TOON
varying vec3 vViewPosition;
#include <common>
#include <batching_pars_vertex>
#include <uv_pars_vertex>
#include <displacementmap_pars_vertex>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <normal_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <shadowmap_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <normal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <displacementmap_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	vViewPosition = - mvPosition.xyz;
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Ay=`#define TOON
uniform vec3 diffuse;
uniform vec3 emissive;
uniform float opacity;
#include <common>
#include <dithering_pars_fragment>
#include <color_pars_fragment>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <aomap_pars_fragment>
#include <lightmap_pars_fragment>
#include <emissivemap_pars_fragment>
#include <gradientmap_pars_fragment>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <normal_pars_fragment>
#include <lights_toon_pars_fragment>
#include <shadowmap_pars_fragment>
#include <bumpmap_pars_fragment>
#include <normalmap_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	ReflectedLight reflectedLight = ReflectedLight( vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ), vec3( 0.0 ) );
	vec3 totalEmissiveRadiance = emissive;
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <color_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	#include <normal_fragment_begin>
	#include <normal_fragment_maps>
	#include <emissivemap_fragment>
	#include <lights_toon_fragment>
	#include <lights_fragment_begin>
	#include <lights_fragment_maps>
	#include <lights_fragment_end>
	#include <aomap_fragment>
	vec3 outgoingLight = reflectedLight.directDiffuse + reflectedLight.indirectDiffuse + totalEmissiveRadiance;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
	#include <dithering_fragment>
}`,Ey=`uniform float size;
uniform float scale;
#include <common>
#include <color_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
#ifdef USE_POINTS_UV
	varying vec2 vUv;
	uniform mat3 uvTransform;
#endif
void main() {
	#ifdef USE_POINTS_UV
		vUv = ( uvTransform * vec3( uv, 1 ) ).xy;
	#endif
	#include <color_vertex>
	#include <morphinstance_vertex>
	#include <morphcolor_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <project_vertex>
	gl_PointSize = size;
	#ifdef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) gl_PointSize *= ( scale / - mvPosition.z );
	#endif
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <worldpos_vertex>
	#include <fog_vertex>
}`,Ty=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <color_pars_fragment>
#include <map_particle_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_particle_fragment>
	#include <color_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Ry=`#include <common>
#include <batching_pars_vertex>
#include <fog_pars_vertex>
#include <morphtarget_pars_vertex>
#include <skinning_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <shadowmap_pars_vertex>
void main() {
	#include <batching_vertex>
	#include <beginnormal_vertex>
	#include <morphinstance_vertex>
	#include <morphnormal_vertex>
	#include <skinbase_vertex>
	#include <skinnormal_vertex>
	#include <defaultnormal_vertex>
	#include <begin_vertex>
	#include <morphtarget_vertex>
	#include <skinning_vertex>
	#include <project_vertex>
	#include <logdepthbuf_vertex>
	#include <worldpos_vertex>
	#include <shadowmap_vertex>
	#include <fog_vertex>
}`,Cy=`uniform vec3 color;
uniform float opacity;
#include <common>
#include <fog_pars_fragment>
#include <bsdfs>
#include <lights_pars_begin>
#include <logdepthbuf_pars_fragment>
#include <shadowmap_pars_fragment>
#include <shadowmask_pars_fragment>
void main() {
	#include <logdepthbuf_fragment>
	gl_FragColor = vec4( color, opacity * ( 1.0 - getShadowMask() ) );
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
	#include <premultiplied_alpha_fragment>
}`,Py=`uniform float rotation;
uniform vec2 center;
#include <common>
#include <uv_pars_vertex>
#include <fog_pars_vertex>
#include <logdepthbuf_pars_vertex>
#include <clipping_planes_pars_vertex>
void main() {
	#include <uv_vertex>
	vec4 mvPosition = modelViewMatrix[ 3 ];
	vec2 scale = vec2( length( modelMatrix[ 0 ].xyz ), length( modelMatrix[ 1 ].xyz ) );
	#ifndef USE_SIZEATTENUATION
		bool isPerspective = isPerspectiveMatrix( projectionMatrix );
		if ( isPerspective ) scale *= - mvPosition.z;
	#endif
	vec2 alignedPosition = ( position.xy - ( center - vec2( 0.5 ) ) ) * scale;
	vec2 rotatedPosition;
	rotatedPosition.x = cos( rotation ) * alignedPosition.x - sin( rotation ) * alignedPosition.y;
	rotatedPosition.y = sin( rotation ) * alignedPosition.x + cos( rotation ) * alignedPosition.y;
	mvPosition.xy += rotatedPosition;
	gl_Position = projectionMatrix * mvPosition;
	#include <logdepthbuf_vertex>
	#include <clipping_planes_vertex>
	#include <fog_vertex>
}`,Iy=`uniform vec3 diffuse;
uniform float opacity;
#include <common>
#include <uv_pars_fragment>
#include <map_pars_fragment>
#include <alphamap_pars_fragment>
#include <alphatest_pars_fragment>
#include <alphahash_pars_fragment>
#include <fog_pars_fragment>
#include <logdepthbuf_pars_fragment>
#include <clipping_planes_pars_fragment>
void main() {
	vec4 diffuseColor = vec4( diffuse, opacity );
	#include <clipping_planes_fragment>
	vec3 outgoingLight = vec3( 0.0 );
	#include <logdepthbuf_fragment>
	#include <map_fragment>
	#include <alphamap_fragment>
	#include <alphatest_fragment>
	#include <alphahash_fragment>
	outgoingLight = diffuseColor.rgb;
	#include <opaque_fragment>
	#include <tonemapping_fragment>
	#include <colorspace_fragment>
	#include <fog_fragment>
}`,Xt={alphahash_fragment:Q0,alphahash_pars_fragment:tx,alphamap_fragment:ex,alphamap_pars_fragment:nx,alphatest_fragment:ix,alphatest_pars_fragment:sx,aomap_fragment:rx,aomap_pars_fragment:ox,batching_pars_vertex:ax,batching_vertex:cx,begin_vertex:lx,beginnormal_vertex:hx,bsdfs:ux,iridescence_fragment:dx,bumpmap_pars_fragment:fx,clipping_planes_fragment:px,clipping_planes_pars_fragment:mx,clipping_planes_pars_vertex:gx,clipping_planes_vertex:xx,color_fragment:_x,color_pars_fragment:yx,color_pars_vertex:vx,color_vertex:Mx,common:Sx,defaultnormal_vertex:bx,displacementmap_pars_vertex:wx,displacementmap_vertex:Ax,emissivemap_fragment:Ex,emissivemap_pars_fragment:Tx,colorspace_fragment:Rx,colorspace_pars_fragment:Cx,envmap_fragment:Px,envmap_common_pars_fragment:Ix,envmap_pars_fragment:Lx,envmap_pars_vertex:Nx,envmap_physical_pars_fragment:Wx,envmap_vertex:Dx,fog_vertex:Ux,fog_pars_vertex:Ox,fog_fragment:Fx,fog_pars_fragment:Bx,gradientmap_pars_fragment:zx,lightmap_pars_fragment:kx,lights_lambert_fragment:Gx,lights_lambert_pars_fragment:Vx,lights_pars_begin:Hx,lights_toon_fragment:qx,lights_toon_pars_fragment:Xx,lights_phong_fragment:$x,lights_phong_pars_fragment:Yx,lights_physical_fragment:Zx,lights_physical_pars_fragment:Jx,lights_fragment_begin:Kx,lights_fragment_maps:jx,lights_fragment_end:Qx,lightprobes_pars_fragment:t_,logdepthbuf_fragment:e_,logdepthbuf_pars_fragment:n_,logdepthbuf_pars_vertex:i_,logdepthbuf_vertex:s_,map_fragment:r_,map_pars_fragment:o_,map_particle_fragment:a_,map_particle_pars_fragment:c_,metalnessmap_fragment:l_,metalnessmap_pars_fragment:h_,morphinstance_vertex:u_,morphcolor_vertex:d_,morphnormal_vertex:f_,morphtarget_pars_vertex:p_,morphtarget_vertex:m_,normal_fragment_begin:g_,normal_fragment_maps:x_,normal_pars_fragment:__,normal_pars_vertex:y_,normal_vertex:v_,normalmap_pars_fragment:M_,clearcoat_normal_fragment_begin:S_,clearcoat_normal_fragment_maps:b_,clearcoat_pars_fragment:w_,iridescence_pars_fragment:A_,opaque_fragment:E_,packing:T_,premultiplied_alpha_fragment:R_,project_vertex:C_,dithering_fragment:P_,dithering_pars_fragment:I_,roughnessmap_fragment:L_,roughnessmap_pars_fragment:N_,shadowmap_pars_fragment:D_,shadowmap_pars_vertex:U_,shadowmap_vertex:O_,shadowmask_pars_fragment:F_,skinbase_vertex:B_,skinning_pars_vertex:z_,skinning_vertex:k_,skinnormal_vertex:G_,specularmap_fragment:V_,specularmap_pars_fragment:H_,tonemapping_fragment:W_,tonemapping_pars_fragment:q_,transmission_fragment:X_,transmission_pars_fragment:$_,uv_pars_fragment:Y_,uv_pars_vertex:Z_,uv_vertex:J_,worldpos_vertex:K_,background_vert:j_,background_frag:Q_,backgroundCube_vert:ty,backgroundCube_frag:ey,cube_vert:ny,cube_frag:iy,depth_vert:sy,depth_frag:ry,distance_vert:oy,distance_frag:ay,equirect_vert:cy,equirect_frag:ly,linedashed_vert:hy,linedashed_frag:uy,meshbasic_vert:dy,meshbasic_frag:fy,meshlambert_vert:py,meshlambert_frag:my,meshmatcap_vert:gy,meshmatcap_frag:xy,meshnormal_vert:_y,meshnormal_frag:yy,meshphong_vert:vy,meshphong_frag:My,meshphysical_vert:Sy,meshphysical_frag:by,meshtoon_vert:wy,meshtoon_frag:Ay,points_vert:Ey,points_frag:Ty,shadow_vert:Ry,shadow_frag:Cy,sprite_vert:Py,sprite_frag:Iy},ft={common:{diffuse:{value:new zt(16777215)},opacity:{value:1},map:{value:null},mapTransform:{value:new Ot},alphaMap:{value:null},alphaMapTransform:{value:new Ot},alphaTest:{value:0}},specularmap:{specularMap:{value:null},specularMapTransform:{value:new Ot}},envmap:{envMap:{value:null},envMapRotation:{value:new Ot},reflectivity:{value:1},ior:{value:1.5},refractionRatio:{value:.98},dfgLUT:{value:null}},aomap:{aoMap:{value:null},aoMapIntensity:{value:1},aoMapTransform:{value:new Ot}},lightmap:{lightMap:{value:null},lightMapIntensity:{value:1},lightMapTransform:{value:new Ot}},bumpmap:{bumpMap:{value:null},bumpMapTransform:{value:new Ot},bumpScale:{value:1}},normalmap:{normalMap:{value:null},normalMapTransform:{value:new Ot},normalScale:{value:new Wt(1,1)}},displacementmap:{displacementMap:{value:null},displacementMapTransform:{value:new Ot},displacementScale:{value:1},displacementBias:{value:0}},emissivemap:{emissiveMap:{value:null},emissiveMapTransform:{value:new Ot}},metalnessmap:{metalnessMap:{value:null},metalnessMapTransform:{value:new Ot}},roughnessmap:{roughnessMap:{value:null},roughnessMapTransform:{value:new Ot}},gradientmap:{gradientMap:{value:null}},fog:{fogDensity:{value:25e-5},fogNear:{value:1},fogFar:{value:2e3},fogColor:{value:new zt(16777215)}},lights:{ambientLightColor:{value:[]},lightProbe:{value:[]},sunLights:{value:[],properties:{direction:{},color:{}}},sunLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},sunShadowMatrix:{value:[]},sunShadowCascade:{value:[]},directionalLights:{value:[],properties:{direction:{},color:{}}},directionalLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},directionalShadowMatrix:{value:[]},spotLights:{value:[],properties:{color:{},position:{},direction:{},distance:{},coneCos:{},penumbraCos:{},decay:{}}},spotLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{}}},spotLightMap:{value:[]},spotLightMatrix:{value:[]},pointLights:{value:[],properties:{color:{},position:{},decay:{},distance:{}}},pointLightShadows:{value:[],properties:{shadowIntensity:1,shadowBias:{},shadowNormalBias:{},shadowRadius:{},shadowMapSize:{},shadowCameraNear:{},shadowCameraFar:{}}},pointShadowMatrix:{value:[]},hemisphereLights:{value:[],properties:{direction:{},skyColor:{},groundColor:{}}},rectAreaLights:{value:[],properties:{color:{},position:{},width:{},height:{}}},ltc_1:{value:null},ltc_2:{value:null},probesSH:{value:[]},probesMin:{value:[]},probesMax:{value:[]},probesResolution:{value:[]}},points:{diffuse:{value:new zt(16777215)},opacity:{value:1},size:{value:1},scale:{value:1},map:{value:null},alphaMap:{value:null},alphaMapTransform:{value:new Ot},alphaTest:{value:0},uvTransform:{value:new Ot}},sprite:{diffuse:{value:new zt(16777215)},opacity:{value:1},center:{value:new Wt(.5,.5)},rotation:{value:0},map:{value:null},mapTransform:{value:new Ot},alphaMap:{value:null},alphaMapTransform:{value:new Ot},alphaTest:{value:0}}},dn={basic:{uniforms:sn([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.fog]),vertexShader:Xt.meshbasic_vert,fragmentShader:Xt.meshbasic_frag},lambert:{uniforms:sn([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new zt(0)},envMapIntensity:{value:1}}]),vertexShader:Xt.meshlambert_vert,fragmentShader:Xt.meshlambert_frag},phong:{uniforms:sn([ft.common,ft.specularmap,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,ft.lights,{emissive:{value:new zt(0)},specular:{value:new zt(1118481)},shininess:{value:30},envMapIntensity:{value:1}}]),vertexShader:Xt.meshphong_vert,fragmentShader:Xt.meshphong_frag},standard:{uniforms:sn([ft.common,ft.envmap,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.roughnessmap,ft.metalnessmap,ft.fog,ft.lights,{emissive:{value:new zt(0)},roughness:{value:1},metalness:{value:0},envMapIntensity:{value:1}}]),vertexShader:Xt.meshphysical_vert,fragmentShader:Xt.meshphysical_frag},toon:{uniforms:sn([ft.common,ft.aomap,ft.lightmap,ft.emissivemap,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.gradientmap,ft.fog,ft.lights,{emissive:{value:new zt(0)}}]),vertexShader:Xt.meshtoon_vert,fragmentShader:Xt.meshtoon_frag},matcap:{uniforms:sn([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,ft.fog,{matcap:{value:null}}]),vertexShader:Xt.meshmatcap_vert,fragmentShader:Xt.meshmatcap_frag},points:{uniforms:sn([ft.points,ft.fog]),vertexShader:Xt.points_vert,fragmentShader:Xt.points_frag},dashed:{uniforms:sn([ft.common,ft.fog,{scale:{value:1},dashSize:{value:1},totalSize:{value:2}}]),vertexShader:Xt.linedashed_vert,fragmentShader:Xt.linedashed_frag},depth:{uniforms:sn([ft.common,ft.displacementmap]),vertexShader:Xt.depth_vert,fragmentShader:Xt.depth_frag},normal:{uniforms:sn([ft.common,ft.bumpmap,ft.normalmap,ft.displacementmap,{opacity:{value:1}}]),vertexShader:Xt.meshnormal_vert,fragmentShader:Xt.meshnormal_frag},sprite:{uniforms:sn([ft.sprite,ft.fog]),vertexShader:Xt.sprite_vert,fragmentShader:Xt.sprite_frag},background:{uniforms:{uvTransform:{value:new Ot},t2D:{value:null},backgroundIntensity:{value:1}},vertexShader:Xt.background_vert,fragmentShader:Xt.background_frag},backgroundCube:{uniforms:{envMap:{value:null},backgroundBlurriness:{value:0},backgroundIntensity:{value:1},backgroundRotation:{value:new Ot}},vertexShader:Xt.backgroundCube_vert,fragmentShader:Xt.backgroundCube_frag},cube:{uniforms:{tCube:{value:null},tFlip:{value:-1},opacity:{value:1}},vertexShader:Xt.cube_vert,fragmentShader:Xt.cube_frag},equirect:{uniforms:{tEquirect:{value:null}},vertexShader:Xt.equirect_vert,fragmentShader:Xt.equirect_frag},distance:{uniforms:sn([ft.common,ft.displacementmap,{referencePosition:{value:new I},nearDistance:{value:1},farDistance:{value:1e3}}]),vertexShader:Xt.distance_vert,fragmentShader:Xt.distance_frag},shadow:{uniforms:sn([ft.lights,ft.fog,{color:{value:new zt(0)},opacity:{value:1}}]),vertexShader:Xt.shadow_vert,fragmentShader:Xt.shadow_frag}};dn.physical={uniforms:sn([dn.standard.uniforms,{clearcoat:{value:0},clearcoatMap:{value:null},clearcoatMapTransform:{value:new Ot},clearcoatNormalMap:{value:null},clearcoatNormalMapTransform:{value:new Ot},clearcoatNormalScale:{value:new Wt(1,1)},clearcoatRoughness:{value:0},clearcoatRoughnessMap:{value:null},clearcoatRoughnessMapTransform:{value:new Ot},diffuseRoughness:{value:0},diffuseRoughnessMap:{value:null},diffuseRoughnessMapTransform:{value:new Ot},dispersion:{value:0},retroreflectivity:{value:0},iridescence:{value:0},iridescenceMap:{value:null},iridescenceMapTransform:{value:new Ot},iridescenceIOR:{value:1.3},iridescenceThicknessMinimum:{value:100},iridescenceThicknessMaximum:{value:400},iridescenceThicknessMap:{value:null},iridescenceThicknessMapTransform:{value:new Ot},sheen:{value:0},sheenColor:{value:new zt(0)},sheenColorMap:{value:null},sheenColorMapTransform:{value:new Ot},sheenRoughness:{value:1},sheenRoughnessMap:{value:null},sheenRoughnessMapTransform:{value:new Ot},transmission:{value:0},transmissionMap:{value:null},transmissionMapTransform:{value:new Ot},transmissionSamplerSize:{value:new Wt},transmissionSamplerMap:{value:null},thickness:{value:0},thicknessMap:{value:null},thicknessMapTransform:{value:new Ot},attenuationDistance:{value:0},attenuationColor:{value:new zt(0)},specularColor:{value:new zt(1,1,1)},specularColorMap:{value:null},specularColorMapTransform:{value:new Ot},specularIntensity:{value:1},specularIntensityMap:{value:null},specularIntensityMapTransform:{value:new Ot},anisotropyVector:{value:new Wt},anisotropyMap:{value:null},anisotropyMapTransform:{value:new Ot}}]),vertexShader:Xt.meshphysical_vert,fragmentShader:Xt.meshphysical_frag};var hl={r:0,b:0,g:0},Ly=new te,vp=new Ot;vp.set(-1,0,0,0,1,0,0,0,1);function Ny(i,t,e,n,s,r){let o=new zt(0),a=s===!0?0:1,c,l,h=null,u=0,d=null;function f(y){let S=y.isScene===!0?y.background:null;if(S&&S.isTexture){let v=y.backgroundBlurriness>0;S=t.get(S,v)}return S}function p(y){let S=!1,v=f(y);v===null?m(o,a):v&&v.isColor&&(m(v,1),S=!0);let A=i.xr.getEnvironmentBlendMode();A==="additive"?e.buffers.color.setClear(0,0,0,1,r):A==="alpha-blend"&&e.buffers.color.setClear(0,0,0,0,r),(i.autoClear||S)&&(e.buffers.depth.setTest(!0),e.buffers.depth.setMask(!0),e.buffers.color.setMask(!0),i.clear(i.autoClearColor,i.autoClearDepth,i.autoClearStencil))}function x(y,S){let v=f(S);v&&v.isCubeTexture?(l===void 0&&(l=new ee(new Ni(1,1,1),new kn({name:"BackgroundCubeMaterial",uniforms:Fs(dn.backgroundCube.uniforms),vertexShader:dn.backgroundCube.vertexShader,fragmentShader:dn.backgroundCube.fragmentShader,side:un,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),l.geometry.deleteAttribute("normal"),l.geometry.deleteAttribute("uv"),l.onBeforeRender=function(A,w,_){this.matrixWorld.copyPosition(_.matrixWorld)},Object.defineProperty(l.material,"envMap",{get:function(){return this.uniforms.envMap.value}}),n.update(l)),l.material.uniforms.envMap.value=v,l.material.uniforms.backgroundBlurriness.value=S.backgroundBlurriness,l.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,l.material.uniforms.backgroundRotation.value.setFromMatrix4(Ly.makeRotationFromEuler(S.backgroundRotation)).transpose(),v.isRenderTargetTexture===!1&&l.material.uniforms.backgroundRotation.value.premultiply(vp),l.material.toneMapped=Kt.getTransfer(v.colorSpace)!==oe,(h!==v||u!==v.version||d!==i.toneMapping)&&(l.material.needsUpdate=!0,h=v,u=v.version,d=i.toneMapping),l.layers.enableAll(),y.unshift(l,l.geometry,l.material,0,0,null)):v&&v.isTexture&&(c===void 0&&(c=new ee(new Ls(2,2),new kn({name:"BackgroundMaterial",uniforms:Fs(dn.background.uniforms),vertexShader:dn.background.vertexShader,fragmentShader:dn.background.fragmentShader,side:ss,depthTest:!1,depthWrite:!1,fog:!1,allowOverride:!1})),c.geometry.deleteAttribute("normal"),Object.defineProperty(c.material,"map",{get:function(){return this.uniforms.t2D.value}}),n.update(c)),c.material.uniforms.t2D.value=v,c.material.uniforms.backgroundIntensity.value=S.backgroundIntensity,c.material.toneMapped=Kt.getTransfer(v.colorSpace)!==oe,v.matrixAutoUpdate===!0&&v.updateMatrix(),c.material.uniforms.uvTransform.value.copy(v.matrix),(h!==v||u!==v.version||d!==i.toneMapping)&&(c.material.needsUpdate=!0,h=v,u=v.version,d=i.toneMapping),c.layers.enableAll(),y.unshift(c,c.geometry,c.material,0,0,null))}function m(y,S){y.getRGB(hl,gu(i)),e.buffers.color.setClear(hl.r,hl.g,hl.b,S,r)}function g(){l!==void 0&&(l.geometry.dispose(),l.material.dispose(),l=void 0),c!==void 0&&(c.geometry.dispose(),c.material.dispose(),c=void 0)}return{getClearColor:function(){return o},setClearColor:function(y,S=1){o.set(y),a=S,m(o,a)},getClearAlpha:function(){return a},setClearAlpha:function(y){a=y,m(o,a)},render:p,addToRenderList:x,dispose:g}}function Dy(i,t){let e=i.getParameter(i.MAX_VERTEX_ATTRIBS),n={},s=d(null),r=s,o=!1;function a(L,N,F,P,B){let G=!1,H=u(L,P,F,N);r!==H&&(r=H,l(r.object)),G=f(L,P,F,B),G&&p(L,P,F,B),B!==null&&t.update(B,i.ELEMENT_ARRAY_BUFFER),(G||o)&&(o=!1,v(L,N,F,P),B!==null&&i.bindBuffer(i.ELEMENT_ARRAY_BUFFER,t.get(B).buffer))}function c(){return i.createVertexArray()}function l(L){return i.bindVertexArray(L)}function h(L){return i.deleteVertexArray(L)}function u(L,N,F,P){let B=P.wireframe===!0,G=n[N.id];G===void 0&&(G={},n[N.id]=G);let H=L.isInstancedMesh===!0?L.id:0,j=G[H];j===void 0&&(j={},G[H]=j);let W=j[F.id];W===void 0&&(W={},j[F.id]=W);let Y=W[B];return Y===void 0&&(Y=d(c()),W[B]=Y),Y}function d(L){let N=[],F=[],P=[];for(let B=0;B<e;B++)N[B]=0,F[B]=0,P[B]=0;return{geometry:null,program:null,wireframe:!1,newAttributes:N,enabledAttributes:F,attributeDivisors:P,object:L,attributes:{},index:null}}function f(L,N,F,P){let B=r.attributes,G=N.attributes,H=0,j=F.getAttributes();for(let W in j)if(j[W].location>=0){let tt=B[W],gt=G[W];if(gt===void 0&&(W==="instanceMatrix"&&L.instanceMatrix&&(gt=L.instanceMatrix),W==="instanceColor"&&L.instanceColor&&(gt=L.instanceColor)),tt===void 0||tt.attribute!==gt||gt&&tt.data!==gt.data)return!0;H++}return r.attributesNum!==H||r.index!==P}function p(L,N,F,P){let B={},G=N.attributes,H=0,j=F.getAttributes();for(let W in j)if(j[W].location>=0){let tt=G[W];tt===void 0&&(W==="instanceMatrix"&&L.instanceMatrix&&(tt=L.instanceMatrix),W==="instanceColor"&&L.instanceColor&&(tt=L.instanceColor));let gt={};gt.attribute=tt,tt&&tt.data&&(gt.data=tt.data),B[W]=gt,H++}r.attributes=B,r.attributesNum=H,r.index=P}function x(){let L=r.newAttributes;for(let N=0,F=L.length;N<F;N++)L[N]=0}function m(L){g(L,0)}function g(L,N){let F=r.newAttributes,P=r.enabledAttributes,B=r.attributeDivisors;F[L]=1,P[L]===0&&(i.enableVertexAttribArray(L),P[L]=1),B[L]!==N&&(i.vertexAttribDivisor(L,N),B[L]=N)}function y(){let L=r.newAttributes,N=r.enabledAttributes;for(let F=0,P=N.length;F<P;F++)N[F]!==L[F]&&(i.disableVertexAttribArray(F),N[F]=0)}function S(L,N,F,P,B,G,H){H===!0?i.vertexAttribIPointer(L,N,F,B,G):i.vertexAttribPointer(L,N,F,P,B,G)}function v(L,N,F,P){x();let B=P.attributes,G=F.getAttributes(),H=N.defaultAttributeValues;for(let j in G){let W=G[j];if(W.location>=0){let Y=B[j];if(Y===void 0&&(j==="instanceMatrix"&&L.instanceMatrix&&(Y=L.instanceMatrix),j==="instanceColor"&&L.instanceColor&&(Y=L.instanceColor)),Y!==void 0){let tt=Y.normalized,gt=Y.itemSize,wt=t.get(Y);if(wt===void 0)continue;let X=wt.buffer,rt=wt.type,xt=wt.bytesPerElement,At=rt===i.INT||rt===i.UNSIGNED_INT||Y.gpuType===wc;if(Y.isInterleavedBufferAttribute){let pt=Y.data,Dt=pt.isInterleavedBuffer===!0?pt.stride:pt.itemSize,fe=Y.offset;if(pt.isInstancedInterleavedBuffer||pt.isInstancedBufferAttribute){for(let Rt=0;Rt<W.locationSize;Rt++)g(W.location+Rt,pt.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=pt.meshPerAttribute*pt.count)}else for(let Rt=0;Rt<W.locationSize;Rt++)m(W.location+Rt);i.bindBuffer(i.ARRAY_BUFFER,X);for(let Rt=0;Rt<W.locationSize;Rt++)S(W.location+Rt,gt/W.locationSize,rt,tt,Dt*xt,(fe+gt/W.locationSize*Rt)*xt,At)}else{if(Y.isInstancedBufferAttribute){for(let pt=0;pt<W.locationSize;pt++)g(W.location+pt,Y.meshPerAttribute);L.isInstancedMesh!==!0&&P._maxInstanceCount===void 0&&(P._maxInstanceCount=Y.meshPerAttribute*Y.count)}else for(let pt=0;pt<W.locationSize;pt++)m(W.location+pt);i.bindBuffer(i.ARRAY_BUFFER,X);for(let pt=0;pt<W.locationSize;pt++)S(W.location+pt,gt/W.locationSize,rt,tt,gt*xt,gt/W.locationSize*pt*xt,At)}}else if(H!==void 0){let tt=H[j];if(tt!==void 0)switch(tt.length){case 2:i.vertexAttrib2fv(W.location,tt);break;case 3:i.vertexAttrib3fv(W.location,tt);break;case 4:i.vertexAttrib4fv(W.location,tt);break;default:i.vertexAttrib1fv(W.location,tt)}}}}y()}function A(){C();for(let L in n){let N=n[L];for(let F in N){let P=N[F];for(let B in P){let G=P[B];for(let H in G)h(G[H].object),delete G[H];delete P[B]}}delete n[L]}}function w(L){if(n[L.id]===void 0)return;let N=n[L.id];for(let F in N){let P=N[F];for(let B in P){let G=P[B];for(let H in G)h(G[H].object),delete G[H];delete P[B]}}delete n[L.id]}function _(L){for(let N in n){let F=n[N];for(let P in F){let B=F[P];if(B[L.id]===void 0)continue;let G=B[L.id];for(let H in G)h(G[H].object),delete G[H];delete B[L.id]}}}function M(L){for(let N in n){let F=n[N],P=L.isInstancedMesh===!0?L.id:0,B=F[P];if(B!==void 0){for(let G in B){let H=B[G];for(let j in H)h(H[j].object),delete H[j];delete B[G]}delete F[P],Object.keys(F).length===0&&delete n[N]}}}function C(){T(),o=!0,r!==s&&(r=s,l(r.object))}function T(){s.geometry=null,s.program=null,s.wireframe=!1}return{setup:a,reset:C,resetDefaultState:T,dispose:A,releaseStatesOfGeometry:w,releaseStatesOfObject:M,releaseStatesOfProgram:_,initAttributes:x,enableAttribute:m,disableUnusedAttributes:y}}function Uy(i,t,e){let n;function s(c){n=c}function r(c,l){i.drawArrays(n,c,l),e.update(l,n,1)}function o(c,l,h){h!==0&&(i.drawArraysInstanced(n,c,l,h),e.update(l,n,h))}function a(c,l,h){if(h===0)return;t.get("WEBGL_multi_draw").multiDrawArraysWEBGL(n,c,0,l,0,h);let d=0;for(let f=0;f<h;f++)d+=l[f];e.update(d,n,1)}this.setMode=s,this.render=r,this.renderInstances=o,this.renderMultiDraw=a}function Oy(i,t,e,n){let s;function r(){if(s!==void 0)return s;if(t.has("EXT_texture_filter_anisotropic")===!0){let _=t.get("EXT_texture_filter_anisotropic");s=i.getParameter(_.MAX_TEXTURE_MAX_ANISOTROPY_EXT)}else s=0;return s}function o(_){return!(_!==ti&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_FORMAT))}function a(_){let M=_===Qn&&(t.has("EXT_color_buffer_half_float")||t.has("EXT_color_buffer_float"));return!(_!==_n&&_!==Gn&&!M&&n.convert(_)!==i.getParameter(i.IMPLEMENTATION_COLOR_READ_TYPE))}function c(_){if(_==="highp"){if(i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.HIGH_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.HIGH_FLOAT).precision>0)return"highp";_="mediump"}return _==="mediump"&&i.getShaderPrecisionFormat(i.VERTEX_SHADER,i.MEDIUM_FLOAT).precision>0&&i.getShaderPrecisionFormat(i.FRAGMENT_SHADER,i.MEDIUM_FLOAT).precision>0?"mediump":"lowp"}let l=e.precision!==void 0?e.precision:"highp",h=c(l);h!==l&&(It("WebGLRenderer:",l,"not supported, using",h,"instead."),l=h);let u=e.reversedDepthBuffer===!0&&t.has("EXT_clip_control"),d=e.logarithmicDepthBuffer===!0&&u===!1;e.reversedDepthBuffer===!0&&u===!1&&It("WebGLRenderer: Unable to use reversed depth buffer due to missing EXT_clip_control extension. Fallback to default depth buffer."),e.logarithmicDepthBuffer===!0&&u===!0&&It("WebGLRenderer: Logarithmic depth buffer is ignored when reversed depth buffer is enabled.");let f=i.getParameter(i.MAX_TEXTURE_IMAGE_UNITS),p=i.getParameter(i.MAX_VERTEX_TEXTURE_IMAGE_UNITS),x=i.getParameter(i.MAX_TEXTURE_SIZE),m=i.getParameter(i.MAX_CUBE_MAP_TEXTURE_SIZE),g=i.getParameter(i.MAX_VERTEX_ATTRIBS),y=i.getParameter(i.MAX_VERTEX_UNIFORM_VECTORS),S=i.getParameter(i.MAX_VARYING_VECTORS),v=i.getParameter(i.MAX_FRAGMENT_UNIFORM_VECTORS),A=i.getParameter(i.MAX_SAMPLES),w=i.getParameter(i.SAMPLES);return{isWebGL2:!0,getMaxAnisotropy:r,getMaxPrecision:c,textureFormatReadable:o,textureTypeReadable:a,precision:l,logarithmicDepthBuffer:d,reversedDepthBuffer:u,maxTextures:f,maxVertexTextures:p,maxTextureSize:x,maxCubemapSize:m,maxAttributes:g,maxVertexUniforms:y,maxVaryings:S,maxFragmentUniforms:v,maxSamples:A,samples:w}}function Fy(i){let t=this,e=null,n=0,s=!1,r=!1,o=new Jn,a=new Ot,c={value:null,needsUpdate:!1};this.uniform=c,this.numPlanes=0,this.numIntersection=0,this.init=function(u,d){let f=u.length!==0||d||n!==0||s;return s=d,n=u.length,f},this.beginShadows=function(){r=!0,h(null)},this.endShadows=function(){r=!1},this.setGlobalState=function(u,d){e=h(u,d,0)},this.setState=function(u,d,f){let p=u.clippingPlanes,x=u.clipIntersection,m=u.clipShadows,g=i.get(u);if(!s||p===null||p.length===0||r&&!m)r?h(null):l();else{let y=r?0:n,S=y*4,v=g.clippingState||null;c.value=v,v=h(p,d,S,f);for(let A=0;A!==S;++A)v[A]=e[A];g.clippingState=v,this.numIntersection=x?this.numPlanes:0,this.numPlanes+=y}};function l(){c.value!==e&&(c.value=e,c.needsUpdate=n>0),t.numPlanes=n,t.numIntersection=0}function h(u,d,f,p){let x=u!==null?u.length:0,m=null;if(x!==0){if(m=c.value,p!==!0||m===null){let g=f+x*4,y=d.matrixWorldInverse;a.getNormalMatrix(y),(m===null||m.length<g)&&(m=new Float32Array(g));for(let S=0,v=f;S!==x;++S,v+=4)o.copy(u[S]).applyMatrix4(y,a),o.normal.toArray(m,v),m[v+3]=o.constant}c.value=m,c.needsUpdate=!0}return t.numPlanes=x,t.numIntersection=0,m}}var zo=class extends An{constructor(t=1,e={}){super(t,t,e),this.isWebGLCubeRenderTarget=!0;let n={width:t,height:t,depth:1},s=[n,n,n,n,n,n];this.texture=new mo(s),this._setTextureOptions(e),this.texture.isRenderTargetTexture=!0}fromEquirectangularTexture(t,e){this.texture.type=e.type,this.texture.colorSpace=e.colorSpace,this.texture.generateMipmaps=e.generateMipmaps,this.texture.minFilter=e.minFilter,this.texture.magFilter=e.magFilter;let n={uniforms:{tEquirect:{value:null}},vertexShader:`

				varying vec3 vWorldDirection;

				vec3 transformDirection( in vec3 dir, in mat4 matrix ) {

					return normalize( ( matrix * vec4( dir, 0.0 ) ).xyz );

				}

				void main() {

					vWorldDirection = transformDirection( position, modelMatrix );

					#include <begin_vertex>
					#include <project_vertex>

				}
			`,fragmentShader:`

				uniform sampler2D tEquirect;

				varying vec3 vWorldDirection;

				#include <common>

				void main() {

					vec3 direction = normalize( vWorldDirection );

					vec2 sampleUV = equirectUv( direction );

					gl_FragColor = texture2D( tEquirect, sampleUV );

				}
			`},s=new Ni(5,5,5),r=new kn({name:"CubemapFromEquirect",uniforms:Fs(n.uniforms),vertexShader:n.vertexShader,fragmentShader:n.fragmentShader,side:un,blending:Ns});r.uniforms.tEquirect.value=e;let o=new ee(s,r),a=e.minFilter;return e.minFilter===Di&&(e.minFilter=Oe),new xr(1,10,this).update(t,o),e.minFilter=a,o.geometry.dispose(),o.material.dispose(),this}clear(t,e=!0,n=!0,s=!0){let r=t.getRenderTarget();for(let o=0;o<6;o++)t.setRenderTarget(this,o),t.clear(e,n,s);t.setRenderTarget(r)}},jf=256,By=3,zy=20,Mp=256,Sp=16,ky=3,Gy=new I,Vy=new zt,dl=class i{constructor(t){this._renderer=t,this._cubeSize=0,this._sourceTarget=null,this._cubeCamera=new xr(1,10,null),this._boxMesh=new ee(new Ni(5,5,5),null),this._cubemapMaterial=null,this._equirectMaterial=null,this._blurMaterial=null,this._ggxMaterial=null,this._integrationMaterial=null}fromScene(t,e=0,n=.1,s=100,r={}){let{size:o=256,position:a=Gy}=r,c=this._renderer;this._setSize(o);let l=this._allocateTarget(),h=this._getSourceTarget(!0);e>0&&(h.texture.mipmapsAutoUpdate=!1);let u=c.autoClear,d=c.autoClearColor,f=c.autoClearDepth,p=c.autoClearStencil,x=t.background;c.autoClear=!0,c.autoClearColor=!0,c.autoClearDepth=!0,c.autoClearStencil=!0,x===null&&(t.background=c.getClearColor(Vy));let m=new xr(n,s,h);return m.position.copy(a),m.update(c,t),c.autoClear=u,c.autoClearColor=d,c.autoClearDepth=f,c.autoClearStencil=p,t.background=x,e>0&&(h.texture.mipmapsAutoUpdate=!0,this._blur(l,e)),this._applyPMREM(l),l}fromEquirectangular(t,e=null){return this._fromTexture(t,e)}fromCubemap(t,e=null){return this._fromTexture(t,e)}compileCubemapShader(){this._cubemapMaterial===null&&(this._cubemapMaterial=ep(),this._compileMaterial(this._cubemapMaterial))}compileEquirectangularShader(){this._equirectMaterial===null&&(this._equirectMaterial=tp(),this._compileMaterial(this._equirectMaterial))}dispose(){this._sourceTarget!==null&&this._sourceTarget.dispose(),this._cubemapMaterial!==null&&this._cubemapMaterial.dispose(),this._equirectMaterial!==null&&this._equirectMaterial.dispose(),this._blurMaterial!==null&&this._blurMaterial.dispose(),this._ggxMaterial!==null&&this._ggxMaterial.dispose(),this._integrationMaterial!==null&&this._integrationMaterial.dispose(),this._boxMesh.geometry.dispose()}static lodToRoughness(t,e){return e>0?1-Math.sqrt(1-t/e):0}_setSize(t){this._cubeSize=Math.max(jf,fu(t))}_fromTexture(t,e){t.mapping===Us||t.mapping===vr?this._setSize(t.image.length===0?jf:t.image[0].width||t.image[0].image.width):this._setSize(t.image.width/4);let n=e||this._allocateTarget();return this._textureToCubemap(t),this._applyPMREM(n),n}_allocateTarget(){let t=this._cubeSize,e=Qf(t,!1,!1),n=Math.log2(t)-By;for(let s=0;s<=n;s++)e.texture.mipmaps.push({width:t>>s,height:t>>s});return e.texture.name="PMREM",e.texture.isPMREMTexture=!0,e}_getSourceTarget(t=!1){let e=this._cubeSize,n=this._sourceTarget;return(n===null||n.width!==e||t&&n.depthBuffer===!1)&&(n!==null&&n.dispose(),this._sourceTarget=Qf(e,!0,t)),this._sourceTarget}_compileMaterial(t){this._boxMesh.material=t,this._renderer.compile(this._boxMesh,this._cubeCamera.children[0])}_renderCube(t,e,n){let s=this._boxMesh,r=this._cubeCamera;s.material=n,r.renderTarget=t,r.activeMipmapLevel=e;let o=t.width>>e;t.viewport.set(0,0,o,o),r.update(this._renderer,s),t.viewport.set(0,0,t.width,t.height)}_textureToCubemap(t){let e;t.mapping===Us||t.mapping===vr?(this._cubemapMaterial===null&&(this._cubemapMaterial=ep()),e=this._cubemapMaterial,e.uniforms.flipEnvMap.value=t.isRenderTargetTexture===!1?-1:1):(this._equirectMaterial===null&&(this._equirectMaterial=tp()),e=this._equirectMaterial),e.uniforms.envMap.value=t,this._renderCube(this._getSourceTarget(),0,e)}_applyPMREM(t){this._ggxMaterial===null&&(this._ggxMaterial=Hy(),this._integrationMaterial=Wy());let e=this._cubeSize,n=t.texture.mipmaps.length-1,s=this._ggxMaterial.uniforms;s.envMap.value=this._sourceTarget.texture;let r=this._integrationMaterial.uniforms;r.envMap.value=this._sourceTarget.texture,r.sourceLod.value=Math.log2(e/Sp);for(let o=0;o<=n;o++){let a=i.lodToRoughness(o,n);if(o>n-ky)r.roughness.value=a,this._renderCube(t,o,this._integrationMaterial);else{let c=a>0?Math.log2(e)+.5*Math.log2(6/(Mp*Math.pow(a,4)))+.5:0;s.roughness.value=a,s.lodBias.value=c,this._renderCube(t,o,this._ggxMaterial)}}}_blur(t,e){this._blurMaterial===null&&(this._blurMaterial=qy());let n=this._blurMaterial,s=n.uniforms,r=this._sourceTarget;s.sigma.value=Math.min(e,Math.PI)/Math.SQRT2,s.envMap.value=r.texture,this._renderCube(t,0,n),s.envMap.value=t.texture,this._renderCube(r,0,n)}};function Qf(i,t,e){return new zo(i,{minFilter:Di,generateMipmaps:t,type:Qn,colorSpace:no,depthBuffer:e})}function ko(i,t,e){return new kn({name:i,uniforms:t,vertexShader:Xt.cube_vert,fragmentShader:e,side:un,blending:Ns,depthTest:!1,depthWrite:!1})}function Hy(){return ko("PMREMGGXConvolution",{envMap:{value:null},roughness:{value:0},lodBias:{value:0}},`

		#define GGX_SAMPLES ${Mp}u

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float lodBias;

		#include <common>

		// Van der Corput radical inverse
		float radicalInverse_VdC( uint bits ) {

			bits = ( bits << 16u ) | ( bits >> 16u );
			bits = ( ( bits & 0x55555555u ) << 1u ) | ( ( bits & 0xAAAAAAAAu ) >> 1u );
			bits = ( ( bits & 0x33333333u ) << 2u ) | ( ( bits & 0xCCCCCCCCu ) >> 2u );
			bits = ( ( bits & 0x0F0F0F0Fu ) << 4u ) | ( ( bits & 0xF0F0F0F0u ) >> 4u );
			bits = ( ( bits & 0x00FF00FFu ) << 8u ) | ( ( bits & 0xFF00FF00u ) >> 8u );
			return float( bits ) * 2.3283064365386963e-10; // / 0x100000000

		}

		// Hammersley sequence
		vec2 hammersley( uint i, uint N ) {

			return vec2( float( i ) / float( N ), radicalInverse_VdC( i ) );

		}

		void main() {

			vec3 N = normalize( vWorldDirection );

			// For very low roughness, just sample the environment directly
			if ( roughness < 0.001 ) {

				gl_FragColor = vec4( textureLod( envMap, N, 0.0 ).rgb, 1.0 );
				return;

			}

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			// Tangent space basis for VNDF sampling
			vec3 up = abs( N.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, N ) );
			vec3 bitangent = cross( N, tangent );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			for ( uint i = 0u; i < GGX_SAMPLES; i ++ ) {

				vec2 Xi = hammersley( i, GGX_SAMPLES );

				// With V = N, sample the reflected direction directly.
				float invQ = 1.0 / ( 1.0 - Xi.x + alpha2 * Xi.x );
				float NdotL = ( 1.0 - Xi.x - alpha2 * Xi.x ) * invQ;

				if ( NdotL > 0.0 ) {

					float phi = 2.0 * PI * Xi.y;
					float sinTheta = 2.0 * alpha * sqrt( Xi.x * ( 1.0 - Xi.x ) ) * invQ;
					vec3 L = N * NdotL + ( tangent * cos( phi ) + bitangent * sin( phi ) ) * sinTheta;

					// Match the source mip to the sample's solid angle. The terms
					// independent of the sample are precomputed in lodBias.
					float d = alpha2 * invQ;
					float lod = max( log2( d ) + lodBias, 0.0 );

					// Weight by NdotL for the split-sum approximation
					prefilteredColor += textureLod( envMap, L, lod ).rgb * NdotL;
					totalWeight += NdotL;

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function Wy(){return ko("PMREMGGXIntegration",{envMap:{value:null},roughness:{value:0},sourceLod:{value:0},sourceSize:{value:Sp}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float roughness;
		uniform float sourceLod;
		uniform int sourceSize;

		void main() {

			vec3 N = normalize( vWorldDirection );

			float alpha = roughness * roughness;
			float alpha2 = alpha * alpha;

			float texelSize = 2.0 / float( sourceSize );

			vec3 prefilteredColor = vec3( 0.0 );
			float totalWeight = 0.0;

			// Pair opposite texels: only the one in N's hemisphere contributes.
			for ( int face = 0; face < 3; face ++ ) {

				for ( int y = 0; y < sourceSize; y ++ ) {

					for ( int x = 0; x < sourceSize; x ++ ) {

						vec2 uv = ( vec2( x, y ) + 0.5 ) * texelSize - 1.0;
						vec3 texelDirection = face == 0 ? vec3( 1.0, uv ) : ( face == 1 ? vec3( uv.x, 1.0, uv.y ) : vec3( uv, 1.0 ) );

						float invDistance = inversesqrt( 1.0 + dot( uv, uv ) );
						float NdotL = dot( N, texelDirection );
						texelDirection *= NdotL < 0.0 ? - 1.0 : 1.0;
						NdotL = abs( NdotL ) * invDistance;

						// With V = N, NdotH squared is ( 1 + NdotL ) / 2. Common factors
						// in the GGX distribution and texel solid angle cancel when normalized.
						float d = 1.0 + alpha2 + ( alpha2 - 1.0 ) * NdotL;
						float weight = NdotL * invDistance * invDistance * invDistance / ( d * d );

						prefilteredColor += textureLod( envMap, texelDirection, sourceLod ).rgb * weight;
						totalWeight += weight;

					}

				}

			}

			gl_FragColor = vec4( prefilteredColor / totalWeight, 1.0 );

		}
	`)}function qy(){return ko("PMREMSphericalGaussianBlur",{envMap:{value:null},sigma:{value:0}},`

		#define SAMPLES ${zy}
		#define GOLDEN_ANGLE 2.39996322973

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float sigma;

		#include <common>

		void main() {

			vec3 outputDirection = normalize( vWorldDirection );

			vec3 up = abs( outputDirection.z ) < 0.999 ? vec3( 0.0, 0.0, 1.0 ) : vec3( 1.0, 0.0, 0.0 );
			vec3 tangent = normalize( cross( up, outputDirection ) );
			vec3 bitangent = cross( outputDirection, tangent );

			// Truncate the kernel at three standard deviations or at the antipode.
			float thetaMax = min( 3.0 * sigma, PI );
			float truncation = 1.0 - exp( - 0.5 * thetaMax * thetaMax / ( sigma * sigma ) );

			vec3 accumColor = vec3( 0.0 );
			float accumWeight = 0.0;

			for ( int i = 0; i < SAMPLES; i ++ ) {

				// Stratified inverse-CDF sampling of the Gaussian, placed on a golden-angle spiral.
				float stratum = ( float( i ) + 0.5 ) / float( SAMPLES );
				float theta = sigma * sqrt( - 2.0 * log( 1.0 - stratum * truncation ) );
				float phi = float( i ) * GOLDEN_ANGLE;

				vec3 offset = cos( phi ) * tangent + sin( phi ) * bitangent;
				vec3 sampleDirection = cos( theta ) * outputDirection + sin( theta ) * offset;

				// Correct the planar sample density to solid angle.
				float weight = sin( theta ) / theta;

				accumColor += weight * textureLod( envMap, sampleDirection, 0.0 ).rgb;
				accumWeight += weight;

			}

			gl_FragColor = vec4( accumColor / accumWeight, 1.0 );

		}
	`)}function tp(){return ko("PMREMEquirectangularToCubemap",{envMap:{value:null}},`

		varying vec3 vWorldDirection;

		uniform sampler2D envMap;

		#include <common>

		void main() {

			// Average four subpixel samples to preserve small, bright features.
			vec3 direction = normalize( vWorldDirection );
			vec3 dx = dFdx( direction ) * 0.25;
			vec3 dy = dFdy( direction ) * 0.25;

			vec3 color = textureLod( envMap, equirectUv( normalize( direction - dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx - dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction - dx + dy ) ), 0.0 ).rgb;
			color += textureLod( envMap, equirectUv( normalize( direction + dx + dy ) ), 0.0 ).rgb;
			gl_FragColor = vec4( color * 0.25, 1.0 );

		}
	`)}function ep(){return ko("PMREMCubemapToCubemap",{envMap:{value:null},flipEnvMap:{value:-1}},`

		varying vec3 vWorldDirection;

		uniform samplerCube envMap;
		uniform float flipEnvMap;

		void main() {

			gl_FragColor = vec4( textureCube( envMap, vec3( flipEnvMap * vWorldDirection.x, vWorldDirection.yz ) ).rgb, 1.0 );

		}
	`)}function Xy(i){let t=new WeakMap,e=new WeakMap,n=null;function s(d,f=!1){return d==null?null:f?o(d):r(d)}function r(d){if(d&&d.isTexture){let f=d.mapping;if(f===Mc||f===Sc)if(t.has(d)){let p=t.get(d).texture;return a(p,d.mapping)}else{let p=d.image;if(p&&p.height>0){let x=new zo(p.height);return x.fromEquirectangularTexture(i,d),t.set(d,x),d.addEventListener("dispose",l),a(x.texture,d.mapping)}else return null}}return d}function o(d){if(d&&d.isTexture&&d.isPMREMTexture!==!0){let f=d.mapping,p=f===Mc||f===Sc,x=f===Us||f===vr;if(p||x){let m=e.get(d),g=m!==void 0?m.texture.pmremVersion:0;if(d.isRenderTargetTexture&&d.pmremVersion!==g)return n===null&&(n=new dl(i)),m=p?n.fromEquirectangular(d,m):n.fromCubemap(d,m),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),m.texture;if(m!==void 0)return m.texture;{let y=d.image;return p&&y&&y.height>0||x&&y&&c(y)?(n===null&&(n=new dl(i)),m=p?n.fromEquirectangular(d):n.fromCubemap(d),m.texture.pmremVersion=d.pmremVersion,e.set(d,m),d.addEventListener("dispose",h),m.texture):null}}}return d}function a(d,f){return f===Mc?d.mapping=Us:f===Sc&&(d.mapping=vr),d}function c(d){let f=0,p=6;for(let x=0;x<p;x++)d[x]!==void 0&&f++;return f===p}function l(d){let f=d.target;f.removeEventListener("dispose",l);let p=t.get(f);p!==void 0&&(t.delete(f),p.dispose())}function h(d){let f=d.target;f.removeEventListener("dispose",h);let p=e.get(f);p!==void 0&&(e.delete(f),p.dispose())}function u(){t=new WeakMap,e=new WeakMap,n!==null&&(n.dispose(),n=null)}return{get:s,dispose:u}}function $y(i){let t={};function e(n){if(t[n]!==void 0)return t[n];let s=i.getExtension(n);return t[n]=s,s}return{has:function(n){return e(n)!==null},init:function(){e("EXT_color_buffer_float"),e("WEBGL_clip_cull_distance"),e("OES_texture_float_linear"),e("EXT_color_buffer_half_float"),e("WEBGL_multisampled_render_to_texture"),e("WEBGL_render_shared_exponent")},get:function(n){let s=e(n);return s===null&&Qr("WebGLRenderer: "+n+" extension not supported."),s}}}function Yy(i,t,e,n){let s={},r=new WeakMap,o=new FinalizationRegistry(p=>delete s[p]);function a(p){c(p.target)}function c(p){p.index!==null&&t.remove(p.index);for(let m in p.attributes)t.remove(p.attributes[m]);p.removeEventListener("dispose",a),delete s[p.id],o.unregister(p);let x=r.get(p);x&&(t.remove(x),r.delete(p)),n.releaseStatesOfGeometry(p),p.isInstancedBufferGeometry===!0&&delete p._maxInstanceCount,e.memory.geometries--}function l(p,x){return s[x.id]!==void 0||(x.addEventListener("dispose",a),s[x.id]=new WeakRef(x),o.register(x,x.id,x),e.memory.geometries++),x}function h(p){let x=p.attributes;for(let m in x)t.update(x[m],i.ARRAY_BUFFER)}function u(p){let x=p.index,m=p.attributes.position,g=0;if(m===void 0)return;let y=x!==null?x.array.length:m.array.length/3-1,S=m.count>=65535?ho:lo,v=new S(Math.ceil(y/3)*6,1),A=v.array;if(x!==null){let _=x.array;g=x.version;for(let M=0,C=0;M<y;M+=3){let T=_[M+0],L=_[M+1],N=_[M+2];A[C++]=T,A[C++]=L,A[C++]=L,A[C++]=N,A[C++]=N,A[C++]=T}}else{g=m.version;for(let _=0,M=0;_<y;_+=3){let C=_+0,T=_+1,L=_+2;A[M++]=C,A[M++]=T,A[M++]=T,A[M++]=L,A[M++]=L,A[M++]=C}}v.version=g;let w=r.get(p);w&&t.remove(w),r.set(p,v)}function d(p){let x=r.get(p);if(x){let m=p.index;m!==null&&x.version<m.version&&u(p)}else u(p);return r.get(p)}function f(){for(let p in s){let x=s[p].deref();x!==void 0&&c(x)}}return{get:l,update:h,getWireframeAttribute:d,dispose:f}}function Zy(i,t,e){let n;function s(u){n=u}let r,o;function a(u){r=u.type,o=u.bytesPerElement}function c(u,d){i.drawElements(n,d,r,u*o),e.update(d,n,1)}function l(u,d,f){f!==0&&(i.drawElementsInstanced(n,d,r,u*o,f),e.update(d,n,f))}function h(u,d,f){if(f===0)return;t.get("WEBGL_multi_draw").multiDrawElementsWEBGL(n,d,0,r,u,0,f);let x=0;for(let m=0;m<f;m++)x+=d[m];e.update(x,n,1)}this.setMode=s,this.setIndex=a,this.render=c,this.renderInstances=l,this.renderMultiDraw=h}function Jy(i){let t={geometries:0,textures:0},e={frame:0,calls:0,triangles:0,points:0,lines:0};function n(r,o,a){switch(e.calls++,o){case i.TRIANGLES:e.triangles+=a*(r/3);break;case i.LINES:e.lines+=a*(r/2);break;case i.LINE_STRIP:e.lines+=a*(r-1);break;case i.LINE_LOOP:e.lines+=a*r;break;case i.POINTS:e.points+=a*r;break;default:Ut("WebGLInfo: Unknown draw mode:",o);break}}function s(){e.calls=0,e.triangles=0,e.points=0,e.lines=0}return{memory:t,render:e,programs:null,autoReset:!0,reset:s,update:n}}function Ky(i,t,e){let n=new WeakMap,s=new ce;function r(o,a,c){let l=o.morphTargetInfluences,h=a.morphAttributes.position||a.morphAttributes.normal||a.morphAttributes.color,u=h!==void 0?h.length:0,d=n.get(a);if(d===void 0||d.count!==u){let C=function(){_.dispose(),n.delete(a),a.removeEventListener("dispose",C)};d!==void 0&&d.texture.dispose();let f=a.morphAttributes.position!==void 0,p=a.morphAttributes.normal!==void 0,x=a.morphAttributes.color!==void 0,m=a.morphAttributes.position||[],g=a.morphAttributes.normal||[],y=a.morphAttributes.color||[],S=0;f===!0&&(S=1),p===!0&&(S=2),x===!0&&(S=3);let v=a.attributes.position.count*S,A=1;v>t.maxTextureSize&&(A=Math.ceil(v/t.maxTextureSize),v=t.maxTextureSize);let w=new Float32Array(v*A*4*u),_=new oo(w,v,A,u);_.type=Gn,_.needsUpdate=!0;let M=S*4;for(let T=0;T<u;T++){let L=m[T],N=g[T],F=y[T],P=v*A*4*T;for(let B=0;B<L.count;B++){let G=B*M;f===!0&&(s.fromBufferAttribute(L,B),w[P+G+0]=s.x,w[P+G+1]=s.y,w[P+G+2]=s.z,w[P+G+3]=0),p===!0&&(s.fromBufferAttribute(N,B),w[P+G+4]=s.x,w[P+G+5]=s.y,w[P+G+6]=s.z,w[P+G+7]=0),x===!0&&(s.fromBufferAttribute(F,B),w[P+G+8]=s.x,w[P+G+9]=s.y,w[P+G+10]=s.z,w[P+G+11]=F.itemSize===4?s.w:1)}}d={count:u,texture:_,size:new Wt(v,A)},n.set(a,d),a.addEventListener("dispose",C)}if(o.isInstancedMesh===!0&&o.morphTexture!==null)c.getUniforms().setValue(i,"morphTexture",o.morphTexture,e);else{let f=0;for(let x=0;x<l.length;x++)f+=l[x];let p=a.morphTargetsRelative?1:1-f;c.getUniforms().setValue(i,"morphTargetBaseInfluence",p),c.getUniforms().setValue(i,"morphTargetInfluences",l)}c.getUniforms().setValue(i,"morphTargetsTexture",d.texture,e),c.getUniforms().setValue(i,"morphTargetsTextureSize",d.size)}return{update:r}}function jy(i,t,e,n,s){let r=new WeakMap;function o(l){let h=s.render.frame,u=l.geometry,d=t.get(l,u);if(r.get(d)!==h&&(t.update(d),r.set(d,h)),l.isInstancedMesh&&(l.hasEventListener("dispose",c)===!1&&l.addEventListener("dispose",c),r.get(l)!==h&&(e.update(l.instanceMatrix,i.ARRAY_BUFFER),l.instanceColor!==null&&e.update(l.instanceColor,i.ARRAY_BUFFER),r.set(l,h))),l.isSkinnedMesh){let f=l.skeleton;r.get(f)!==h&&(f.update(),r.set(f,h))}return d}function a(){r=new WeakMap}function c(l){let h=l.target;h.removeEventListener("dispose",c),n.releaseStatesOfObject(h),e.remove(h.instanceMatrix),h.instanceColor!==null&&e.remove(h.instanceColor)}return{update:o,dispose:a}}var Qy={[$h]:"LINEAR_TONE_MAPPING",[Yh]:"REINHARD_TONE_MAPPING",[Zh]:"CINEON_TONE_MAPPING",[Jh]:"ACES_FILMIC_TONE_MAPPING",[jh]:"AGX_TONE_MAPPING",[Qh]:"NEUTRAL_TONE_MAPPING",[Kh]:"CUSTOM_TONE_MAPPING"};function tv(i,t,e,n,s,r){let o=new An(t,e,{type:i,depthBuffer:s,stencilBuffer:r,samples:n?4:0,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,resolveDepthBuffer:!1,resolveStencilBuffer:!1}),a=null,c=null,l=null,h=new Ee;h.setAttribute("position",new re([-1,3,0,-1,-1,0,3,-1,0],3)),h.setAttribute("uv",new re([0,2,0,0,2,0],2));let u=new rc({uniforms:{tDiffuse:{value:null}},vertexShader:`
			precision highp float;

			uniform mat4 modelViewMatrix;
			uniform mat4 projectionMatrix;

			attribute vec3 position;
			attribute vec2 uv;

			varying vec2 vUv;

			void main() {
				vUv = uv;
				gl_Position = projectionMatrix * modelViewMatrix * vec4( position, 1.0 );
			}`,fragmentShader:`
			precision highp float;

			uniform sampler2D tDiffuse;

			varying vec2 vUv;

			#include <tonemapping_pars_fragment>
			#include <colorspace_pars_fragment>

			void main() {
				gl_FragColor = texture2D( tDiffuse, vUv );

				#ifdef LINEAR_TONE_MAPPING
					gl_FragColor.rgb = LinearToneMapping( gl_FragColor.rgb );
				#elif defined( REINHARD_TONE_MAPPING )
					gl_FragColor.rgb = ReinhardToneMapping( gl_FragColor.rgb );
				#elif defined( CINEON_TONE_MAPPING )
					gl_FragColor.rgb = CineonToneMapping( gl_FragColor.rgb );
				#elif defined( ACES_FILMIC_TONE_MAPPING )
					gl_FragColor.rgb = ACESFilmicToneMapping( gl_FragColor.rgb );
				#elif defined( AGX_TONE_MAPPING )
					gl_FragColor.rgb = AgXToneMapping( gl_FragColor.rgb );
				#elif defined( NEUTRAL_TONE_MAPPING )
					gl_FragColor.rgb = NeutralToneMapping( gl_FragColor.rgb );
				#elif defined( CUSTOM_TONE_MAPPING )
					gl_FragColor.rgb = CustomToneMapping( gl_FragColor.rgb );
				#endif

				#ifdef SRGB_TRANSFER
					gl_FragColor = sRGBTransferOETF( gl_FragColor );
				#endif
			}`,depthTest:!1,depthWrite:!1}),d=new ee(h,u),f=new bo(-1,1,1,-1,0,1),p=null,x=null,m=!1,g,y=null,S=[],v=!1;this.setSize=function(A,w){o.setSize(A,w),a!==null&&a.setSize(A,w),c!==null&&c.setSize(A,w);for(let _=0;_<S.length;_++){let M=S[_];M.setSize&&M.setSize(A,w)}},this.setEffects=function(A){S=A,v=S.length>0&&S[0].isRenderPass===!0;let w=o.width,_=o.height;S.length>0&&a===null&&(a=new An(w,_,{type:Qn,depthBuffer:!1,stencilBuffer:!1}),c=new An(w,_,{type:Qn,depthBuffer:!1,stencilBuffer:!1}));let M=s===!0&&S.some(C=>C.needsDepthTexture===!0);M!==(o.depthTexture!==null)&&(M===!0&&l===null&&(l=new Li(w,_),r===!0&&(l.format=Ui,l.type=Os)),o.dispose(),o.depthTexture=M?l:null,o.resolveDepthBuffer=M,o.storeMultisampledDepthBuffer=M);for(let C=0;C<S.length;C++){let T=S[C];T.setSize&&T.setSize(w,_),M&&T.needsDepthTexture===!0&&T.setDepthTexture&&T.setDepthTexture(l)}},this.begin=function(A,w){if(m||A.toneMapping===ui&&S.length===0)return!1;if(y=w,w!==null){let _=w.width,M=w.height;(o.width!==_||o.height!==M)&&this.setSize(_,M)}return v===!1&&A.setRenderTarget(o),g=A.toneMapping,A.toneMapping=ui,!0},this.hasRenderPass=function(){return v},this.end=function(A,w){A.toneMapping=g,m=!0;let _=o,M=a;for(let C=0;C<S.length;C++){let T=S[C];T.enabled!==!1&&(T.render(A,M,_,w),T.needsSwap!==!1&&(_=M,M=M===a?c:a))}if(p!==A.outputColorSpace||x!==A.toneMapping){p=A.outputColorSpace,x=A.toneMapping,u.defines={},Kt.getTransfer(p)===oe&&(u.defines.SRGB_TRANSFER="");let C=Qy[x];C&&(u.defines[C]=""),u.needsUpdate=!0}u.uniforms.tDiffuse.value=_.texture,A.setRenderTarget(y),A.render(d,f),y=null,m=!1},this.isCompositing=function(){return m},this.dispose=function(){o.dispose(),a!==null&&a.dispose(),c!==null&&c.dispose(),h.dispose(),u.dispose()}}var bp=new gn,wp=new Li(1,1),Ap=new go(1),Ep=new oo,Tp=new tc,Rp=new mo,np=[],ip=[],sp=new Float32Array(16),rp=new Float32Array(9),op=new Float32Array(4);function br(i,t,e){let n=i[0];if(n<=0||n>0)return i;let s=t*e,r=np[s];if(r===void 0&&(r=new Float32Array(s),np[s]=r),t!==0){n.toArray(r,0);for(let o=1,a=0;o!==t;++o)a+=e,i[o].toArray(r,a)}return r}function Fe(i,t){if(i.length!==t.length)return!1;for(let e=0,n=i.length;e<n;e++)if(i[e]!==t[e])return!1;return!0}function Be(i,t){for(let e=0,n=t.length;e<n;e++)i[e]=t[e]}function pl(i,t){let e=ip[t];e===void 0&&(e=new Int32Array(t),ip[t]=e);for(let n=0;n!==t;++n)e[n]=i.allocateTextureUnit();return e}function ev(i,t){let e=this.cache;e[0]!==t&&(i.uniform1f(this.addr,t),e[0]=t)}function nv(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2f(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Fe(e,t))return;i.uniform2fv(this.addr,t),Be(e,t)}}function iv(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3f(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else if(t.r!==void 0)(e[0]!==t.r||e[1]!==t.g||e[2]!==t.b)&&(i.uniform3f(this.addr,t.r,t.g,t.b),e[0]=t.r,e[1]=t.g,e[2]=t.b);else{if(Fe(e,t))return;i.uniform3fv(this.addr,t),Be(e,t)}}function sv(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4f(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Fe(e,t))return;i.uniform4fv(this.addr,t),Be(e,t)}}function rv(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Fe(e,t))return;i.uniformMatrix2fv(this.addr,!1,t),Be(e,t)}else{if(Fe(e,n))return;op.set(n),i.uniformMatrix2fv(this.addr,!1,op),Be(e,n)}}function ov(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Fe(e,t))return;i.uniformMatrix3fv(this.addr,!1,t),Be(e,t)}else{if(Fe(e,n))return;rp.set(n),i.uniformMatrix3fv(this.addr,!1,rp),Be(e,n)}}function av(i,t){let e=this.cache,n=t.elements;if(n===void 0){if(Fe(e,t))return;i.uniformMatrix4fv(this.addr,!1,t),Be(e,t)}else{if(Fe(e,n))return;sp.set(n),i.uniformMatrix4fv(this.addr,!1,sp),Be(e,n)}}function cv(i,t){let e=this.cache;e[0]!==t&&(i.uniform1i(this.addr,t),e[0]=t)}function lv(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2i(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Fe(e,t))return;i.uniform2iv(this.addr,t),Be(e,t)}}function hv(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3i(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Fe(e,t))return;i.uniform3iv(this.addr,t),Be(e,t)}}function uv(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4i(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Fe(e,t))return;i.uniform4iv(this.addr,t),Be(e,t)}}function dv(i,t){let e=this.cache;e[0]!==t&&(i.uniform1ui(this.addr,t),e[0]=t)}function fv(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y)&&(i.uniform2ui(this.addr,t.x,t.y),e[0]=t.x,e[1]=t.y);else{if(Fe(e,t))return;i.uniform2uiv(this.addr,t),Be(e,t)}}function pv(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z)&&(i.uniform3ui(this.addr,t.x,t.y,t.z),e[0]=t.x,e[1]=t.y,e[2]=t.z);else{if(Fe(e,t))return;i.uniform3uiv(this.addr,t),Be(e,t)}}function mv(i,t){let e=this.cache;if(t.x!==void 0)(e[0]!==t.x||e[1]!==t.y||e[2]!==t.z||e[3]!==t.w)&&(i.uniform4ui(this.addr,t.x,t.y,t.z,t.w),e[0]=t.x,e[1]=t.y,e[2]=t.z,e[3]=t.w);else{if(Fe(e,t))return;i.uniform4uiv(this.addr,t),Be(e,t)}}function ml(i){return i.version===0&&(i.compareFunction=lu,i.needsUpdate=!0),i}function gv(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_2D_SHADOW?r=ml(wp):r=bp,e.setTexture2D(t||r,s)}function xv(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture3D(t||Tp,s)}function _v(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s);let r;this.type===i.SAMPLER_CUBE_SHADOW?r=ml(Ap):r=Rp,e.setTextureCube(t||r,s)}function yv(i,t,e){let n=this.cache,s=e.allocateTextureUnit();n[0]!==s&&(i.uniform1i(this.addr,s),n[0]=s),e.setTexture2DArray(t||Ep,s)}function vv(i){switch(i){case 5126:return ev;case 35664:return nv;case 35665:return iv;case 35666:return sv;case 35674:return rv;case 35675:return ov;case 35676:return av;case 5124:case 35670:return cv;case 35667:case 35671:return lv;case 35668:case 35672:return hv;case 35669:case 35673:return uv;case 5125:return dv;case 36294:return fv;case 36295:return pv;case 36296:return mv;case 35678:case 36198:case 36298:case 36306:case 35682:return gv;case 35679:case 36299:case 36307:return xv;case 35680:case 36300:case 36308:case 36293:return _v;case 36289:case 36303:case 36311:case 36292:return yv}}function Mv(i,t){i.uniform1fv(this.addr,t)}function Sv(i,t){let e=br(t,this.size,2);i.uniform2fv(this.addr,e)}function bv(i,t){let e=br(t,this.size,3);i.uniform3fv(this.addr,e)}function wv(i,t){let e=br(t,this.size,4);i.uniform4fv(this.addr,e)}function Av(i,t){let e=br(t,this.size,4);i.uniformMatrix2fv(this.addr,!1,e)}function Ev(i,t){let e=br(t,this.size,9);i.uniformMatrix3fv(this.addr,!1,e)}function Tv(i,t){let e=br(t,this.size,16);i.uniformMatrix4fv(this.addr,!1,e)}function Rv(i,t){i.uniform1iv(this.addr,t)}function Cv(i,t){i.uniform2iv(this.addr,t)}function Pv(i,t){i.uniform3iv(this.addr,t)}function Iv(i,t){i.uniform4iv(this.addr,t)}function Lv(i,t){i.uniform1uiv(this.addr,t)}function Nv(i,t){i.uniform2uiv(this.addr,t)}function Dv(i,t){i.uniform3uiv(this.addr,t)}function Uv(i,t){i.uniform4uiv(this.addr,t)}function Ov(i,t,e){let n=this.cache,s=t.length,r=pl(e,s);Fe(n,r)||(i.uniform1iv(this.addr,r),Be(n,r));let o;this.type===i.SAMPLER_2D_SHADOW?o=ml(wp):o=bp;for(let a=0;a!==s;++a)e.setTexture2D(t[a]||o,r[a])}function Fv(i,t,e){let n=this.cache,s=t.length,r=pl(e,s);Fe(n,r)||(i.uniform1iv(this.addr,r),Be(n,r));for(let o=0;o!==s;++o)e.setTexture3D(t[o]||Tp,r[o])}function Bv(i,t,e){let n=this.cache,s=t.length,r=pl(e,s);Fe(n,r)||(i.uniform1iv(this.addr,r),Be(n,r));let o;this.type===i.SAMPLER_CUBE_SHADOW?o=ml(Ap):o=Rp;for(let a=0;a!==s;++a)e.setTextureCube(t[a]||o,r[a])}function zv(i,t,e){let n=this.cache,s=t.length,r=pl(e,s);Fe(n,r)||(i.uniform1iv(this.addr,r),Be(n,r));for(let o=0;o!==s;++o)e.setTexture2DArray(t[o]||Ep,r[o])}function kv(i){switch(i){case 5126:return Mv;case 35664:return Sv;case 35665:return bv;case 35666:return wv;case 35674:return Av;case 35675:return Ev;case 35676:return Tv;case 5124:case 35670:return Rv;case 35667:case 35671:return Cv;case 35668:case 35672:return Pv;case 35669:case 35673:return Iv;case 5125:return Lv;case 36294:return Nv;case 36295:return Dv;case 36296:return Uv;case 35678:case 36198:case 36298:case 36306:case 35682:return Ov;case 35679:case 36299:case 36307:return Fv;case 35680:case 36300:case 36308:case 36293:return Bv;case 36289:case 36303:case 36311:case 36292:return zv}}var Su=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.setValue=vv(e.type)}},bu=class{constructor(t,e,n){this.id=t,this.addr=n,this.cache=[],this.type=e.type,this.size=e.size,this.setValue=kv(e.type)}},wu=class{constructor(t){this.id=t,this.seq=[],this.map={}}setValue(t,e,n){let s=this.seq;for(let r=0,o=s.length;r!==o;++r){let a=s[r];a.setValue(t,e[a.id],n)}}},vu=/(\w+)(\])?(\[|\.)?/g;function ap(i,t){i.seq.push(t),i.map[t.id]=t}function Gv(i,t,e){let n=i.name,s=n.length;for(vu.lastIndex=0;;){let r=vu.exec(n),o=vu.lastIndex,a=r[1],c=r[2]==="]",l=r[3];if(c&&(a=a|0),l===void 0||l==="["&&o+2===s){ap(e,l===void 0?new Su(a,i,t):new bu(a,i,t));break}else{let u=e.map[a];u===void 0&&(u=new wu(a),ap(e,u)),e=u}}}var Sr=class{constructor(t,e){this.seq=[],this.map={};let n=t.getProgramParameter(e,t.ACTIVE_UNIFORMS);for(let o=0;o<n;++o){let a=t.getActiveUniform(e,o),c=t.getUniformLocation(e,a.name);Gv(a,c,this)}let s=[],r=[];for(let o of this.seq)o.type===t.SAMPLER_2D_SHADOW||o.type===t.SAMPLER_CUBE_SHADOW||o.type===t.SAMPLER_2D_ARRAY_SHADOW?s.push(o):r.push(o);s.length>0&&(this.seq=s.concat(r))}setValue(t,e,n,s){let r=this.map[e];r!==void 0&&r.setValue(t,n,s)}setOptional(t,e,n){let s=e[n];s!==void 0&&this.setValue(t,n,s)}static upload(t,e,n,s){for(let r=0,o=e.length;r!==o;++r){let a=e[r],c=n[a.id];c.needsUpdate!==!1&&a.setValue(t,c.value,s)}}static seqWithValue(t,e){let n=[];for(let s=0,r=t.length;s!==r;++s){let o=t[s];o.id in e&&n.push(o)}return n}};function cp(i,t,e){let n=i.createShader(t);return i.shaderSource(n,e),i.compileShader(n),n}var Vv=37297,Hv=0;function Wv(i,t){let e=i.split(`
`),n=[],s=Math.max(t-6,0),r=Math.min(t+6,e.length);for(let o=s;o<r;o++){let a=o+1;n.push(`${a===t?">":" "} ${a}: ${e[o]}`)}return n.join(`
`)}var lp=new Ot;function qv(i){Kt._getMatrix(lp,Kt.workingColorSpace,i);let t=`mat3( ${lp.elements.map(e=>e.toFixed(4))} )`;switch(Kt.getTransfer(i)){case io:return[t,"LinearTransferOETF"];case oe:return[t,"sRGBTransferOETF"];default:return It("WebGLProgram: Unsupported color space: ",i),[t,"LinearTransferOETF"]}}function hp(i,t,e){let n=i.getShaderParameter(t,i.COMPILE_STATUS),r=(i.getShaderInfoLog(t)||"").trim();if(n&&r==="")return"";let o=/ERROR: 0:(\d+)/.exec(r);if(o){let a=parseInt(o[1]);return e.toUpperCase()+`

`+r+`

`+Wv(i.getShaderSource(t),a)}else return r}function Xv(i,t){let e=qv(t);return[`vec4 ${i}( vec4 value ) {`,`	return ${e[1]}( vec4( ${e[0]} * value.rgb, value.a ) );`,"}"].join(`
`)}var $v={[$h]:"Linear",[Yh]:"Reinhard",[Zh]:"Cineon",[Jh]:"ACESFilmic",[jh]:"AgX",[Qh]:"Neutral",[Kh]:"Custom"};function Yv(i,t){let e=$v[t];return e===void 0?(It("WebGLProgram: Unsupported toneMapping:",t),"vec3 "+i+"( vec3 color ) { return LinearToneMapping( color ); }"):"vec3 "+i+"( vec3 color ) { return "+e+"ToneMapping( color ); }"}var ul=new I;function Zv(){Kt.getLuminanceCoefficients(ul);let i=ul.x.toFixed(4),t=ul.y.toFixed(4),e=ul.z.toFixed(4);return["float luminance( const in vec3 rgb ) {",`	const vec3 weights = vec3( ${i}, ${t}, ${e} );`,"	return dot( weights, rgb );","}"].join(`
`)}function Jv(i){return[i.extensionClipCullDistance?"#extension GL_ANGLE_clip_cull_distance : require":"",i.extensionMultiDraw?"#extension GL_ANGLE_multi_draw : require":""].filter(Bo).join(`
`)}function Kv(i){let t=[];for(let e in i){let n=i[e];n!==!1&&t.push("#define "+e+" "+n)}return t.join(`
`)}function jv(i,t){let e={},n=i.getProgramParameter(t,i.ACTIVE_ATTRIBUTES);for(let s=0;s<n;s++){let r=i.getActiveAttrib(t,s),o=r.name,a=1;r.type===i.FLOAT_MAT2&&(a=2),r.type===i.FLOAT_MAT3&&(a=3),r.type===i.FLOAT_MAT4&&(a=4),e[o]={type:r.type,location:i.getAttribLocation(t,o),locationSize:a}}return e}function Bo(i){return i!==""}function up(i,t){let e=t.numSpotLightShadows+t.numSpotLightMaps-t.numSpotLightShadowsWithMaps;return i.replace(/NUM_SUN_LIGHTS/g,t.numSunLights).replace(/NUM_DIR_LIGHTS/g,t.numDirLights).replace(/NUM_SPOT_LIGHTS/g,t.numSpotLights).replace(/NUM_SPOT_LIGHT_MAPS/g,t.numSpotLightMaps).replace(/NUM_SPOT_LIGHT_COORDS/g,e).replace(/NUM_RECT_AREA_LIGHTS/g,t.numRectAreaLights).replace(/NUM_POINT_LIGHTS/g,t.numPointLights).replace(/NUM_HEMI_LIGHTS/g,t.numHemiLights).replace(/NUM_SUN_LIGHT_SHADOWS/g,t.numSunLightShadows).replace(/NUM_DIR_LIGHT_SHADOWS/g,t.numDirLightShadows).replace(/NUM_SPOT_LIGHT_SHADOWS_WITH_MAPS/g,t.numSpotLightShadowsWithMaps).replace(/NUM_SPOT_LIGHT_SHADOWS/g,t.numSpotLightShadows).replace(/NUM_POINT_LIGHT_SHADOWS/g,t.numPointLightShadows).replace(/NUM_LIGHT_PROBE_GRIDS/g,t.numLightProbeGrids)}function dp(i,t){return i.replace(/NUM_CLIPPING_PLANES/g,t.numClippingPlanes).replace(/UNION_CLIPPING_PLANES/g,t.numClippingPlanes-t.numClipIntersection)}var Qv=/^[ \t]*#include +<([\w\d./]+)>/gm;function Au(i){return i.replace(Qv,tM)}function tM(i,t){let e=Xt[t];if(e===void 0)throw new Error("THREE.WebGLProgram: Can not resolve #include <"+t+">");return Au(e)}var eM=/#pragma unroll_loop_start\s+for\s*\(\s*int\s+i\s*=\s*(\d+)\s*;\s*i\s*<\s*(\d+)\s*;\s*i\s*\+\+\s*\)\s*{([\s\S]+?)}\s+#pragma unroll_loop_end/g;function fp(i){return i.replace(eM,nM)}function nM(i,t,e,n){let s="";for(let r=parseInt(t);r<parseInt(e);r++)s+=n.replace(/\[\s*i\s*\]/g,"[ "+r+" ]").replace(/UNROLLED_LOOP_INDEX/g,r);return s}function pp(i){let t=`precision ${i.precision} float;
	precision ${i.precision} int;
	precision ${i.precision} sampler2D;
	precision ${i.precision} samplerCube;
	precision ${i.precision} sampler3D;
	precision ${i.precision} sampler2DArray;
	precision ${i.precision} sampler2DShadow;
	precision ${i.precision} samplerCubeShadow;
	precision ${i.precision} sampler2DArrayShadow;
	precision ${i.precision} isampler2D;
	precision ${i.precision} isampler3D;
	precision ${i.precision} isamplerCube;
	precision ${i.precision} isampler2DArray;
	precision ${i.precision} usampler2D;
	precision ${i.precision} usampler3D;
	precision ${i.precision} usamplerCube;
	precision ${i.precision} usampler2DArray;
	`;return i.precision==="highp"?t+=`
#define HIGH_PRECISION`:i.precision==="mediump"?t+=`
#define MEDIUM_PRECISION`:i.precision==="lowp"&&(t+=`
#define LOW_PRECISION`),t}var iM={[Ro]:"SHADOWMAP_TYPE_PCF",[_r]:"SHADOWMAP_TYPE_VSM"};function sM(i){return iM[i.shadowMapType]||"SHADOWMAP_TYPE_BASIC"}var rM={[vr]:"ENVMAP_MODE_REFRACTION"};function oM(i){return i.envMap===!1?"ENVMAP_MODE_REFLECTION":rM[i.envMapMode]||"ENVMAP_MODE_REFLECTION"}var aM={[vc]:"ENVMAP_BLENDING_MULTIPLY",[Df]:"ENVMAP_BLENDING_MIX",[Uf]:"ENVMAP_BLENDING_ADD"};function cM(i){return i.envMap===!1?"ENVMAP_BLENDING_NONE":aM[i.combine]||"ENVMAP_BLENDING_NONE"}function lM(i,t,e,n){let s=i.getContext(),r=e.defines,o=e.vertexShader,a=e.fragmentShader,c=sM(e),l=e.envMapPMREM===!0?"ENVMAP_TYPE_PMREM":"ENVMAP_TYPE_CUBE",h=oM(e),u=cM(e),d=Jv(e),f=Kv(r),p=s.createProgram(),x,m,g=e.glslVersion?"#version "+e.glslVersion+`
`:"";e.isRawShaderMaterial?(x=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Bo).join(`
`),x.length>0&&(x+=`
`),m=["#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f].filter(Bo).join(`
`),m.length>0&&(m+=`
`)):(x=[pp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.extensionClipCullDistance?"#define USE_CLIP_DISTANCE":"",e.batching?"#define USE_BATCHING":"",e.batchingColor?"#define USE_BATCHING_COLOR":"",e.instancing?"#define USE_INSTANCING":"",e.instancingColor?"#define USE_INSTANCING_COLOR":"",e.instancingMorph?"#define USE_INSTANCING_MORPH":"",e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.map?"#define USE_MAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+h:"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.displacementMap?"#define USE_DISPLACEMENTMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.mapUv?"#define MAP_UV "+e.mapUv:"",e.alphaMapUv?"#define ALPHAMAP_UV "+e.alphaMapUv:"",e.lightMapUv?"#define LIGHTMAP_UV "+e.lightMapUv:"",e.aoMapUv?"#define AOMAP_UV "+e.aoMapUv:"",e.emissiveMapUv?"#define EMISSIVEMAP_UV "+e.emissiveMapUv:"",e.bumpMapUv?"#define BUMPMAP_UV "+e.bumpMapUv:"",e.normalMapUv?"#define NORMALMAP_UV "+e.normalMapUv:"",e.displacementMapUv?"#define DISPLACEMENTMAP_UV "+e.displacementMapUv:"",e.metalnessMapUv?"#define METALNESSMAP_UV "+e.metalnessMapUv:"",e.roughnessMapUv?"#define ROUGHNESSMAP_UV "+e.roughnessMapUv:"",e.anisotropyMapUv?"#define ANISOTROPYMAP_UV "+e.anisotropyMapUv:"",e.clearcoatMapUv?"#define CLEARCOATMAP_UV "+e.clearcoatMapUv:"",e.clearcoatNormalMapUv?"#define CLEARCOAT_NORMALMAP_UV "+e.clearcoatNormalMapUv:"",e.clearcoatRoughnessMapUv?"#define CLEARCOAT_ROUGHNESSMAP_UV "+e.clearcoatRoughnessMapUv:"",e.diffuseRoughnessMapUv?"#define DIFFUSE_ROUGHNESSMAP_UV "+e.diffuseRoughnessMapUv:"",e.iridescenceMapUv?"#define IRIDESCENCEMAP_UV "+e.iridescenceMapUv:"",e.iridescenceThicknessMapUv?"#define IRIDESCENCE_THICKNESSMAP_UV "+e.iridescenceThicknessMapUv:"",e.sheenColorMapUv?"#define SHEEN_COLORMAP_UV "+e.sheenColorMapUv:"",e.sheenRoughnessMapUv?"#define SHEEN_ROUGHNESSMAP_UV "+e.sheenRoughnessMapUv:"",e.specularMapUv?"#define SPECULARMAP_UV "+e.specularMapUv:"",e.specularColorMapUv?"#define SPECULAR_COLORMAP_UV "+e.specularColorMapUv:"",e.specularIntensityMapUv?"#define SPECULAR_INTENSITYMAP_UV "+e.specularIntensityMapUv:"",e.transmissionMapUv?"#define TRANSMISSIONMAP_UV "+e.transmissionMapUv:"",e.thicknessMapUv?"#define THICKNESSMAP_UV "+e.thicknessMapUv:"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexNormals?"#define HAS_NORMAL":"",e.vertexColors?"#define USE_COLOR":"",e.vertexAlphas?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.flatShading?"#define FLAT_SHADED":"",e.skinning?"#define USE_SKINNING":"",e.morphTargets?"#define USE_MORPHTARGETS":"",e.morphNormals&&e.flatShading===!1?"#define USE_MORPHNORMALS":"",e.morphColors?"#define USE_MORPHCOLORS":"",e.morphTargetsCount>0?"#define MORPHTARGETS_TEXTURE_STRIDE "+e.morphTextureStride:"",e.morphTargetsCount>0?"#define MORPHTARGETS_COUNT "+e.morphTargetsCount:"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.sizeAttenuation?"#define USE_SIZEATTENUATION":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 modelMatrix;","uniform mat4 modelViewMatrix;","uniform mat4 projectionMatrix;","uniform mat4 viewMatrix;","uniform mat3 normalMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;","#ifdef USE_INSTANCING","	attribute mat4 instanceMatrix;","#endif","#ifdef USE_INSTANCING_COLOR","	attribute vec3 instanceColor;","#endif","#ifdef USE_INSTANCING_MORPH","	uniform sampler2D morphTexture;","#endif","attribute vec3 position;","attribute vec3 normal;","attribute vec2 uv;","#ifdef USE_UV1","	attribute vec2 uv1;","#endif","#ifdef USE_UV2","	attribute vec2 uv2;","#endif","#ifdef USE_UV3","	attribute vec2 uv3;","#endif","#ifdef USE_TANGENT","	attribute vec4 tangent;","#endif","#if defined( USE_COLOR_ALPHA )","	attribute vec4 color;","#elif defined( USE_COLOR )","	attribute vec3 color;","#endif","#ifdef USE_SKINNING","	attribute vec4 skinIndex;","	attribute vec4 skinWeight;","#endif",`
`].filter(Bo).join(`
`),m=[pp(e),"#define SHADER_TYPE "+e.shaderType,"#define SHADER_NAME "+e.shaderName,f,e.useFog&&e.fog?"#define USE_FOG":"",e.useFog&&e.fogExp2?"#define FOG_EXP2":"",e.alphaToCoverage?"#define ALPHA_TO_COVERAGE":"",e.map?"#define USE_MAP":"",e.matcap?"#define USE_MATCAP":"",e.envMap?"#define USE_ENVMAP":"",e.envMap?"#define "+l:"",e.envMap?"#define "+h:"",e.envMap?"#define "+u:"",e.envMapPMREM?"#define ENVMAP_MAX_LOD "+e.envMapMaxLod+".0":"",e.envMapPMREM?"#define ENVMAP_SIZE "+e.envMapSize+".0":"",e.lightMap?"#define USE_LIGHTMAP":"",e.aoMap?"#define USE_AOMAP":"",e.bumpMap?"#define USE_BUMPMAP":"",e.normalMap?"#define USE_NORMALMAP":"",e.normalMapObjectSpace?"#define USE_NORMALMAP_OBJECTSPACE":"",e.normalMapTangentSpace?"#define USE_NORMALMAP_TANGENTSPACE":"",e.packedNormalMap?"#define USE_PACKED_NORMALMAP":"",e.emissiveMap?"#define USE_EMISSIVEMAP":"",e.anisotropy?"#define USE_ANISOTROPY":"",e.anisotropyMap?"#define USE_ANISOTROPYMAP":"",e.clearcoat?"#define USE_CLEARCOAT":"",e.clearcoatMap?"#define USE_CLEARCOATMAP":"",e.clearcoatRoughnessMap?"#define USE_CLEARCOAT_ROUGHNESSMAP":"",e.clearcoatNormalMap?"#define USE_CLEARCOAT_NORMALMAP":"",e.diffuseRoughness?"#define USE_DIFFUSE_ROUGHNESS":"",e.diffuseRoughnessMap?"#define USE_DIFFUSE_ROUGHNESSMAP":"",e.dispersion?"#define USE_DISPERSION":"",e.retroreflection?"#define USE_RETROREFLECTION":"",e.iridescence?"#define USE_IRIDESCENCE":"",e.iridescenceMap?"#define USE_IRIDESCENCEMAP":"",e.iridescenceThicknessMap?"#define USE_IRIDESCENCE_THICKNESSMAP":"",e.specularMap?"#define USE_SPECULARMAP":"",e.specularColorMap?"#define USE_SPECULAR_COLORMAP":"",e.specularIntensityMap?"#define USE_SPECULAR_INTENSITYMAP":"",e.roughnessMap?"#define USE_ROUGHNESSMAP":"",e.metalnessMap?"#define USE_METALNESSMAP":"",e.alphaMap?"#define USE_ALPHAMAP":"",e.alphaTest?"#define USE_ALPHATEST":"",e.alphaHash?"#define USE_ALPHAHASH":"",e.sheen?"#define USE_SHEEN":"",e.sheenColorMap?"#define USE_SHEEN_COLORMAP":"",e.sheenRoughnessMap?"#define USE_SHEEN_ROUGHNESSMAP":"",e.transmission?"#define USE_TRANSMISSION":"",e.transmissionMap?"#define USE_TRANSMISSIONMAP":"",e.thicknessMap?"#define USE_THICKNESSMAP":"",e.vertexTangents&&e.flatShading===!1?"#define USE_TANGENT":"",e.vertexColors||e.instancingColor?"#define USE_COLOR":"",e.vertexAlphas||e.batchingColor?"#define USE_COLOR_ALPHA":"",e.vertexUv1s?"#define USE_UV1":"",e.vertexUv2s?"#define USE_UV2":"",e.vertexUv3s?"#define USE_UV3":"",e.pointsUvs?"#define USE_POINTS_UV":"",e.gradientMap?"#define USE_GRADIENTMAP":"",e.flatShading?"#define FLAT_SHADED":"",e.doubleSided?"#define DOUBLE_SIDED":"",e.flipSided?"#define FLIP_SIDED":"",e.shadowMapEnabled?"#define USE_SHADOWMAP":"",e.shadowMapEnabled?"#define "+c:"",e.premultipliedAlpha?"#define PREMULTIPLIED_ALPHA":"",e.numLightProbes>0?"#define USE_LIGHT_PROBES":"",e.decodeVideoTexture?"#define DECODE_VIDEO_TEXTURE":"",e.decodeVideoTextureEmissive?"#define DECODE_VIDEO_TEXTURE_EMISSIVE":"",e.logarithmicDepthBuffer?"#define USE_LOGARITHMIC_DEPTH_BUFFER":"",e.reversedDepthBuffer?"#define USE_REVERSED_DEPTH_BUFFER":"","uniform mat4 viewMatrix;","uniform vec3 cameraPosition;","uniform bool isOrthographic;",e.toneMapping!==ui?"#define TONE_MAPPING":"",e.toneMapping!==ui?Xt.tonemapping_pars_fragment:"",e.toneMapping!==ui?Yv("toneMapping",e.toneMapping):"",e.dithering?"#define DITHERING":"",e.opaque?"#define OPAQUE":"",Xt.colorspace_pars_fragment,Xv("linearToOutputTexel",e.outputColorSpace),Zv(),e.useDepthPacking?"#define DEPTH_PACKING "+e.depthPacking:"",`
`].filter(Bo).join(`
`)),o=Au(o),o=up(o,e),o=dp(o,e),a=Au(a),a=up(a,e),a=dp(a,e),o=fp(o),a=fp(a),e.isRawShaderMaterial!==!0&&(g=`#version 300 es
`,x=[d,"#define attribute in","#define varying out","#define texture2D texture"].join(`
`)+`
`+x,m=["#define varying in",e.glslVersion===uu?"":"layout(location = 0) out highp vec4 pc_fragColor;",e.glslVersion===uu?"":"#define gl_FragColor pc_fragColor","#define gl_FragDepthEXT gl_FragDepth","#define texture2D texture","#define textureCube texture","#define texture2DProj textureProj","#define texture2DLodEXT textureLod","#define texture2DProjLodEXT textureProjLod","#define textureCubeLodEXT textureLod","#define texture2DGradEXT textureGrad","#define texture2DProjGradEXT textureProjGrad","#define textureCubeGradEXT textureGrad"].join(`
`)+`
`+m);let y=g+x+o,S=g+m+a,v=cp(s,s.VERTEX_SHADER,y),A=cp(s,s.FRAGMENT_SHADER,S);s.attachShader(p,v),s.attachShader(p,A),e.index0AttributeName!==void 0?s.bindAttribLocation(p,0,e.index0AttributeName):e.hasPositionAttribute===!0&&s.bindAttribLocation(p,0,"position"),s.linkProgram(p);function w(T){if(i.debug.checkShaderErrors){let L=s.getProgramInfoLog(p)||"",N=s.getShaderInfoLog(v)||"",F=s.getShaderInfoLog(A)||"",P=L.trim(),B=N.trim(),G=F.trim(),H=!0,j=!0;if(s.getProgramParameter(p,s.LINK_STATUS)===!1)if(H=!1,typeof i.debug.onShaderError=="function")i.debug.onShaderError(s,p,v,A);else{let W=hp(s,v,"vertex"),Y=hp(s,A,"fragment");Ut("WebGLProgram: Shader Error "+s.getError()+" - VALIDATE_STATUS "+s.getProgramParameter(p,s.VALIDATE_STATUS)+`

Material Name: `+T.name+`
Material Type: `+T.type+`

Program Info Log: `+P+`
`+W+`
`+Y)}else P!==""?It("WebGLProgram: Program Info Log:",P):(B===""||G==="")&&(j=!1);j&&(T.diagnostics={runnable:H,programLog:P,vertexShader:{log:B,prefix:x},fragmentShader:{log:G,prefix:m}})}s.deleteShader(v),s.deleteShader(A),_=new Sr(s,p),M=jv(s,p)}let _;this.getUniforms=function(){return _===void 0&&w(this),_};let M;this.getAttributes=function(){return M===void 0&&w(this),M};let C=e.rendererExtensionParallelShaderCompile===!1;return this.isReady=function(){return C===!1&&(C=s.getProgramParameter(p,Vv)),C},this.destroy=function(){n.releaseStatesOfProgram(this),s.deleteProgram(p),this.program=void 0},this.type=e.shaderType,this.name=e.shaderName,this.id=Hv++,this.cacheKey=t,this.usedTimes=1,this.program=p,this.vertexShader=v,this.fragmentShader=A,this}var hM=0,Eu=class{constructor(){this.shaderCache=new Map,this.materialCache=new Map}update(t,e,n){let s=this._getShaderCacheForMaterial(t);return s.has(e)===!1&&(s.add(e),e.usedTimes++),s.has(n)===!1&&(s.add(n),n.usedTimes++),this}remove(t){let e=this.materialCache.get(t);for(let n of e)n.usedTimes--,n.usedTimes===0&&this.shaderCache.delete(n.code);return this.materialCache.delete(t),this}getVertexShaderStage(t){return this._getShaderStage(t.vertexShader)}getFragmentShaderStage(t){return this._getShaderStage(t.fragmentShader)}dispose(){this.shaderCache.clear(),this.materialCache.clear()}_getShaderCacheForMaterial(t){let e=this.materialCache,n=e.get(t);return n===void 0&&(n=new Set,e.set(t,n)),n}_getShaderStage(t){let e=this.shaderCache,n=e.get(t);return n===void 0&&(n=new Tu(t),e.set(t,n)),n}},Tu=class{constructor(t){this.id=hM++,this.code=t,this.usedTimes=0}};function uM(i){return i===rs||i===Do||i===Uo}function dM(i,t,e,n,s,r){let o=new ao,a=new Eu,c=new Set,l=[],h=new Map,u=n.logarithmicDepthBuffer,d={MeshDepthMaterial:"depth",MeshDistanceMaterial:"distance",MeshNormalMaterial:"normal",MeshBasicMaterial:"basic",MeshLambertMaterial:"lambert",MeshPhongMaterial:"phong",MeshToonMaterial:"toon",MeshStandardMaterial:"physical",MeshPhysicalMaterial:"physical",MeshMatcapMaterial:"matcap",LineBasicMaterial:"basic",LineDashedMaterial:"dashed",PointsMaterial:"points",ShadowMaterial:"shadow",SpriteMaterial:"sprite"};function f(_){return c.add(_),_===0?"uv":`uv${_}`}function p(_,M,C,T,L,N){let F=T.fog,P=L.geometry,B=_.isMeshStandardMaterial||_.isMeshLambertMaterial||_.isMeshPhongMaterial?T.environment:null,G=_.isMeshStandardMaterial||_.isMeshLambertMaterial&&!_.envMap||_.isMeshPhongMaterial&&!_.envMap,H=t.get(_.envMap||B,G),j=d[_.type],W=n.precision;_.precision!==null&&(W=n.getMaxPrecision(_.precision),W!==_.precision&&It("WebGLProgram.getParameters:",_.precision,"not supported, using",W,"instead."));let Y=P.morphAttributes.position||P.morphAttributes.normal||P.morphAttributes.color,tt=Y!==void 0?Y.length:0,gt=0;P.morphAttributes.position!==void 0&&(gt=1),P.morphAttributes.normal!==void 0&&(gt=2),P.morphAttributes.color!==void 0&&(gt=3);let wt,X,rt,xt;if(j){let _t=dn[j];wt=_t.vertexShader,X=_t.fragmentShader}else{wt=_.vertexShader,X=_.fragmentShader;let _t=a.getVertexShaderStage(_),le=a.getFragmentShaderStage(_);a.update(_,_t,le),rt=_t.id,xt=le.id}let At=i.getRenderTarget(),pt=i.state.buffers.depth.getReversed(),Dt=L.isInstancedMesh===!0,fe=L.isBatchedMesh===!0,Rt=!!_.map,Yt=!!_.matcap,jt=!!H,kt=jt&&H.isPMREMTexture===!0,we=!!_.aoMap,xe=!!_.lightMap,ie=!!_.bumpMap&&_.wireframe===!1,pe=!!_.normalMap,Mn=!!_.displacementMap,Ce=!!_.emissiveMap,rn=!!_.metalnessMap,Dn=!!_.roughnessMap,Un=_.anisotropy>0,O=_.clearcoat>0,On=_.diffuseRoughness>0,ve=_.dispersion>0,Me=_.retroreflectivity>0,mt=_.iridescence>0,Ue=_.sheen>0,Lt=_.transmission>0,Ft=Un&&!!_.anisotropyMap,R=O&&!!_.clearcoatMap,b=O&&!!_.clearcoatNormalMap,k=O&&!!_.clearcoatRoughnessMap,et=On&&!!_.diffuseRoughnessMap,Q=mt&&!!_.iridescenceMap,ot=mt&&!!_.iridescenceThicknessMap,ut=Ue&&!!_.sheenColorMap,Z=Ue&&!!_.sheenRoughnessMap,J=!!_.specularMap,ct=!!_.specularColorMap,D=!!_.specularIntensityMap,K=Lt&&!!_.transmissionMap,$=Lt&&!!_.thicknessMap,lt=!!_.gradientMap,it=!!_.alphaMap,at=_.alphaTest>0,Ct=!!_.alphaHash,qt=!!_.extensions,nt=ui;_.toneMapped&&(At===null||At.isXRRenderTarget===!0)&&(nt=i.toneMapping);let Pt=kt?H.isCompressedCubeTexture?H.image[0].mipmaps:H.mipmaps:null,Ht={shaderID:j,shaderType:_.type,shaderName:_.name,vertexShader:wt,fragmentShader:X,defines:_.defines,customVertexShaderID:rt,customFragmentShaderID:xt,isRawShaderMaterial:_.isRawShaderMaterial===!0,glslVersion:_.glslVersion,precision:W,batching:fe,batchingColor:fe&&L._colorsTexture!==null,instancing:Dt,instancingColor:Dt&&L.instanceColor!==null,instancingMorph:Dt&&L.morphTexture!==null,outputColorSpace:At===null?i.outputColorSpace:At.isXRRenderTarget===!0?At.texture.colorSpace:Kt.workingColorSpace,alphaToCoverage:!!_.alphaToCoverage,map:Rt,matcap:Yt,envMap:jt,envMapMode:jt&&H.mapping,envMapPMREM:kt,envMapMaxLod:kt?Pt.length-1:null,envMapSize:kt?Pt[0].width:null,aoMap:we,lightMap:xe,bumpMap:ie,normalMap:pe,displacementMap:Mn,emissiveMap:Ce,normalMapObjectSpace:pe&&_.normalMapType===Bf,normalMapTangentSpace:pe&&_.normalMapType===al,packedNormalMap:pe&&_.normalMapType===al&&uM(_.normalMap.format),metalnessMap:rn,roughnessMap:Dn,anisotropy:Un,anisotropyMap:Ft,clearcoat:O,clearcoatMap:R,clearcoatNormalMap:b,clearcoatRoughnessMap:k,diffuseRoughness:On,diffuseRoughnessMap:et,dispersion:ve,retroreflection:Me,iridescence:mt,iridescenceMap:Q,iridescenceThicknessMap:ot,sheen:Ue,sheenColorMap:ut,sheenRoughnessMap:Z,specularMap:J,specularColorMap:ct,specularIntensityMap:D,transmission:Lt,transmissionMap:K,thicknessMap:$,gradientMap:lt,opaque:_.transparent===!1&&_.blending===yr&&_.alphaToCoverage===!1,alphaMap:it,alphaTest:at,alphaHash:Ct,combine:_.combine,mapUv:Rt&&f(_.map.channel),aoMapUv:we&&f(_.aoMap.channel),lightMapUv:xe&&f(_.lightMap.channel),bumpMapUv:ie&&f(_.bumpMap.channel),normalMapUv:pe&&f(_.normalMap.channel),displacementMapUv:Mn&&f(_.displacementMap.channel),emissiveMapUv:Ce&&f(_.emissiveMap.channel),metalnessMapUv:rn&&f(_.metalnessMap.channel),roughnessMapUv:Dn&&f(_.roughnessMap.channel),anisotropyMapUv:Ft&&f(_.anisotropyMap.channel),clearcoatMapUv:R&&f(_.clearcoatMap.channel),clearcoatNormalMapUv:b&&f(_.clearcoatNormalMap.channel),clearcoatRoughnessMapUv:k&&f(_.clearcoatRoughnessMap.channel),diffuseRoughnessMapUv:et&&f(_.diffuseRoughnessMap.channel),iridescenceMapUv:Q&&f(_.iridescenceMap.channel),iridescenceThicknessMapUv:ot&&f(_.iridescenceThicknessMap.channel),sheenColorMapUv:ut&&f(_.sheenColorMap.channel),sheenRoughnessMapUv:Z&&f(_.sheenRoughnessMap.channel),specularMapUv:J&&f(_.specularMap.channel),specularColorMapUv:ct&&f(_.specularColorMap.channel),specularIntensityMapUv:D&&f(_.specularIntensityMap.channel),transmissionMapUv:K&&f(_.transmissionMap.channel),thicknessMapUv:$&&f(_.thicknessMap.channel),alphaMapUv:it&&f(_.alphaMap.channel),vertexTangents:!!P.attributes.tangent&&(pe||Un),vertexNormals:!!P.attributes.normal,vertexColors:_.vertexColors,vertexAlphas:_.vertexColors===!0&&!!P.attributes.color&&P.attributes.color.itemSize===4,pointsUvs:L.isPoints===!0&&!!P.attributes.uv&&(Rt||it),fog:!!F,useFog:_.fog===!0,fogExp2:!!F&&F.isFogExp2,flatShading:_.wireframe===!1&&(_.flatShading===!0||P.attributes.normal===void 0&&pe===!1&&(_.isMeshLambertMaterial||_.isMeshPhongMaterial||_.isMeshStandardMaterial||_.isMeshPhysicalMaterial)),sizeAttenuation:_.sizeAttenuation===!0,logarithmicDepthBuffer:u,reversedDepthBuffer:pt,skinning:L.isSkinnedMesh===!0,hasPositionAttribute:P.attributes.position!==void 0,morphTargets:P.morphAttributes.position!==void 0,morphNormals:P.morphAttributes.normal!==void 0,morphColors:P.morphAttributes.color!==void 0,morphTargetsCount:tt,morphTextureStride:gt,numSunLights:M.sun.length,numDirLights:M.directional.length,numPointLights:M.point.length,numSpotLights:M.spot.length,numSpotLightMaps:M.spotLightMap.length,numRectAreaLights:M.rectArea.length,numHemiLights:M.hemi.length,numSunLightShadows:M.sunShadowMap.length,numDirLightShadows:M.directionalShadowMap.length,numPointLightShadows:M.pointShadowMap.length,numSpotLightShadows:M.spotShadowMap.length,numSpotLightShadowsWithMaps:M.numSpotLightShadowsWithMaps,numLightProbes:M.numLightProbes,numLightProbeGrids:N.filter(_t=>_t.texture!==null).length,numClippingPlanes:r.numPlanes,numClipIntersection:r.numIntersection,dithering:_.dithering,shadowMapEnabled:i.shadowMap.enabled&&C.length>0,shadowMapType:i.shadowMap.type,toneMapping:nt,decodeVideoTexture:Rt&&_.map.isVideoTexture===!0&&Kt.getTransfer(_.map.colorSpace)===oe,decodeVideoTextureEmissive:Ce&&_.emissiveMap.isVideoTexture===!0&&Kt.getTransfer(_.emissiveMap.colorSpace)===oe,premultipliedAlpha:_.premultipliedAlpha,doubleSided:_.side===hi,flipSided:_.side===un,useDepthPacking:_.depthPacking>=0,depthPacking:_.depthPacking||0,index0AttributeName:_.index0AttributeName,extensionClipCullDistance:qt&&_.extensions.clipCullDistance===!0&&e.has("WEBGL_clip_cull_distance"),extensionMultiDraw:(qt&&_.extensions.multiDraw===!0||fe)&&e.has("WEBGL_multi_draw"),rendererExtensionParallelShaderCompile:e.has("KHR_parallel_shader_compile"),customProgramCacheKey:_.customProgramCacheKey()};return Ht.vertexUv1s=c.has(1),Ht.vertexUv2s=c.has(2),Ht.vertexUv3s=c.has(3),c.clear(),Ht}function x(_){let M=[];if(_.shaderID?M.push(_.shaderID):(M.push(_.customVertexShaderID),M.push(_.customFragmentShaderID)),_.defines!==void 0)for(let C in _.defines)M.push(C),M.push(_.defines[C]);return _.isRawShaderMaterial===!1&&(m(M,_),g(M,_),M.push(i.outputColorSpace)),M.push(_.customProgramCacheKey),M.join()}function m(_,M){_.push(M.precision),_.push(M.outputColorSpace),_.push(M.envMapMode),_.push(M.envMapPMREM),_.push(M.envMapMaxLod),_.push(M.envMapSize),_.push(M.mapUv),_.push(M.alphaMapUv),_.push(M.lightMapUv),_.push(M.aoMapUv),_.push(M.bumpMapUv),_.push(M.normalMapUv),_.push(M.displacementMapUv),_.push(M.emissiveMapUv),_.push(M.metalnessMapUv),_.push(M.roughnessMapUv),_.push(M.anisotropyMapUv),_.push(M.clearcoatMapUv),_.push(M.clearcoatNormalMapUv),_.push(M.clearcoatRoughnessMapUv),_.push(M.diffuseRoughnessMapUv),_.push(M.iridescenceMapUv),_.push(M.iridescenceThicknessMapUv),_.push(M.sheenColorMapUv),_.push(M.sheenRoughnessMapUv),_.push(M.specularMapUv),_.push(M.specularColorMapUv),_.push(M.specularIntensityMapUv),_.push(M.transmissionMapUv),_.push(M.thicknessMapUv),_.push(M.combine),_.push(M.fogExp2),_.push(M.sizeAttenuation),_.push(M.morphTargetsCount),_.push(M.numSunLights),_.push(M.numDirLights),_.push(M.numPointLights),_.push(M.numSpotLights),_.push(M.numSpotLightMaps),_.push(M.numHemiLights),_.push(M.numRectAreaLights),_.push(M.numSunLightShadows),_.push(M.numDirLightShadows),_.push(M.numPointLightShadows),_.push(M.numSpotLightShadows),_.push(M.numSpotLightShadowsWithMaps),_.push(M.numLightProbes),_.push(M.numLightProbeGrids),_.push(M.shadowMapType),_.push(M.toneMapping),_.push(M.numClippingPlanes),_.push(M.numClipIntersection),_.push(M.depthPacking)}function g(_,M){o.disableAll(),M.instancing&&o.enable(0),M.instancingColor&&o.enable(1),M.instancingMorph&&o.enable(2),M.matcap&&o.enable(3),M.envMap&&o.enable(4),M.normalMapObjectSpace&&o.enable(5),M.normalMapTangentSpace&&o.enable(6),M.clearcoat&&o.enable(7),M.iridescence&&o.enable(8),M.alphaTest&&o.enable(9),M.vertexColors&&o.enable(10),M.vertexAlphas&&o.enable(11),M.vertexUv1s&&o.enable(12),M.vertexUv2s&&o.enable(13),M.vertexUv3s&&o.enable(14),M.vertexTangents&&o.enable(15),M.anisotropy&&o.enable(16),M.alphaHash&&o.enable(17),M.batching&&o.enable(18),M.dispersion&&o.enable(19),M.retroreflection&&o.enable(24),M.diffuseRoughness&&o.enable(25),M.batchingColor&&o.enable(20),M.gradientMap&&o.enable(21),M.packedNormalMap&&o.enable(22),M.vertexNormals&&o.enable(23),_.push(o.mask),o.disableAll(),M.fog&&o.enable(0),M.useFog&&o.enable(1),M.flatShading&&o.enable(2),M.logarithmicDepthBuffer&&o.enable(3),M.reversedDepthBuffer&&o.enable(4),M.skinning&&o.enable(5),M.morphTargets&&o.enable(6),M.morphNormals&&o.enable(7),M.morphColors&&o.enable(8),M.premultipliedAlpha&&o.enable(9),M.shadowMapEnabled&&o.enable(10),M.doubleSided&&o.enable(11),M.flipSided&&o.enable(12),M.useDepthPacking&&o.enable(13),M.dithering&&o.enable(14),M.transmission&&o.enable(15),M.sheen&&o.enable(16),M.opaque&&o.enable(17),M.pointsUvs&&o.enable(18),M.decodeVideoTexture&&o.enable(19),M.decodeVideoTextureEmissive&&o.enable(20),M.alphaToCoverage&&o.enable(21),M.numLightProbeGrids>0&&o.enable(22),M.hasPositionAttribute&&o.enable(23),_.push(o.mask)}function y(_){let M=d[_.type],C;if(M){let T=dn[M];C=Oo.clone(T.uniforms)}else C=_.uniforms;return C}function S(_,M){let C=h.get(M);return C!==void 0?++C.usedTimes:(C=new lM(i,M,_,s),l.push(C),h.set(M,C)),C}function v(_){if(--_.usedTimes===0){let M=l.indexOf(_);l[M]=l[l.length-1],l.pop(),h.delete(_.cacheKey),_.destroy()}}function A(_){a.remove(_)}function w(){a.dispose()}return{getParameters:p,getProgramCacheKey:x,getUniforms:y,acquireProgram:S,releaseProgram:v,releaseShaderCache:A,programs:l,dispose:w}}function fM(){let i=new WeakMap;function t(o){return i.has(o)}function e(o){let a=i.get(o);return a===void 0&&(a={},i.set(o,a)),a}function n(o){i.delete(o)}function s(o,a,c){i.get(o)[a]=c}function r(){i=new WeakMap}return{has:t,get:e,remove:n,update:s,dispose:r}}function pM(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.material.id!==t.material.id?i.material.id-t.material.id:i.materialVariant!==t.materialVariant?i.materialVariant-t.materialVariant:i.z!==t.z?i.z-t.z:i.id-t.id}function mp(i,t){return i.groupOrder!==t.groupOrder?i.groupOrder-t.groupOrder:i.renderOrder!==t.renderOrder?i.renderOrder-t.renderOrder:i.z!==t.z?t.z-i.z:i.id-t.id}function gp(){let i=[],t=0,e=[],n=[],s=[];function r(){t=0,e.length=0,n.length=0,s.length=0}function o(d){let f=0;return d.isInstancedMesh&&(f+=2),d.isSkinnedMesh&&(f+=1),f}function a(d,f,p,x,m,g){let y=i[t];return y===void 0?(y={id:d.id,object:d,geometry:f,material:p,materialVariant:o(d),groupOrder:x,renderOrder:d.renderOrder,z:m,group:g},i[t]=y):(y.id=d.id,y.object=d,y.geometry=f,y.material=p,y.materialVariant=o(d),y.groupOrder=x,y.renderOrder=d.renderOrder,y.z=m,y.group=g),t++,y}function c(d,f,p,x,m,g,y){y.reversedDepth===!0&&(m=-m);let S=a(d,f,p,x,m,g);p.transmission>0?n.push(S):p.transparent===!0?s.push(S):e.push(S)}function l(d,f,p,x,m,g){let y=a(d,f,p,x,m,g);p.transmission>0?n.unshift(y):p.transparent===!0?s.unshift(y):e.unshift(y)}function h(d,f){e.length>1&&e.sort(d||pM),n.length>1&&n.sort(f||mp),s.length>1&&s.sort(f||mp)}function u(){for(let d=t,f=i.length;d<f;d++){let p=i[d];if(p.id===null)break;p.id=null,p.object=null,p.geometry=null,p.material=null,p.group=null}}return{opaque:e,transmissive:n,transparent:s,init:r,push:c,unshift:l,finish:u,sort:h}}function mM(){let i=new WeakMap;function t(n,s){let r=i.get(n),o;return r===void 0?(o=new gp,i.set(n,[o])):s>=r.length?(o=new gp,r.push(o)):o=r[s],o}function e(){i=new WeakMap}return{get:t,dispose:e}}function gM(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={direction:new I,color:new zt};break;case"SpotLight":e={position:new I,direction:new I,color:new zt,distance:0,coneCos:0,penumbraCos:0,decay:0};break;case"PointLight":e={position:new I,color:new zt,distance:0,decay:0};break;case"HemisphereLight":e={direction:new I,skyColor:new zt,groundColor:new zt};break;case"RectAreaLight":e={color:new zt,position:new I,halfWidth:new I,halfHeight:new I};break}return i[t.id]=e,e}}}function xM(){let i={};return{get:function(t){if(i[t.id]!==void 0)return i[t.id];let e;switch(t.type){case"SunLight":case"DirectionalLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Wt};break;case"SpotLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Wt};break;case"PointLight":e={shadowIntensity:1,shadowBias:0,shadowNormalBias:0,shadowRadius:1,shadowMapSize:new Wt,shadowCameraNear:1,shadowCameraFar:1e3};break}return i[t.id]=e,e}}}var _M=0;function yM(i,t){return(t.castShadow?2:0)-(i.castShadow?2:0)+(t.map?1:0)-(i.map?1:0)}function vM(i){let t=new gM,e=xM(),n={version:0,hash:{sunLength:-1,directionalLength:-1,pointLength:-1,spotLength:-1,rectAreaLength:-1,hemiLength:-1,numSunShadows:-1,numDirectionalShadows:-1,numPointShadows:-1,numSpotShadows:-1,numSpotMaps:-1,numLightProbes:-1},ambient:[0,0,0],probe:[],sun:[],sunShadow:[],sunShadowMap:[],sunShadowMatrix:[],sunShadowCascade:[],directional:[],directionalShadow:[],directionalShadowMap:[],directionalShadowMatrix:[],spot:[],spotLightMap:[],spotShadow:[],spotShadowMap:[],spotLightMatrix:[],rectArea:[],rectAreaLTC1:null,rectAreaLTC2:null,point:[],pointShadow:[],pointShadowMap:[],pointShadowMatrix:[],hemi:[],numSpotLightShadowsWithMaps:0,numLightProbes:0};for(let l=0;l<9;l++)n.probe.push(new I);let s=new I,r=new te,o=new te;function a(l){let h=0,u=0,d=0;for(let N=0;N<9;N++)n.probe[N].set(0,0,0);let f=0,p=0,x=0,m=0,g=0,y=0,S=0,v=0,A=0,w=0,_=0,M=0,C=0,T=0;l.sort(yM);for(let N=0,F=l.length;N<F;N++){let P=l[N],B=P.color,G=P.intensity,H=P.distance,j=null;if(P.shadow&&P.shadow.map&&(P.shadow.map.texture.format===rs?j=P.shadow.map.texture:j=P.shadow.map.depthTexture||P.shadow.map.texture),P.isAmbientLight)h+=B.r*G,u+=B.g*G,d+=B.b*G;else if(P.isLightProbe){for(let W=0;W<9;W++)n.probe[W].addScaledVector(P.sh.coefficients[W],G);T++}else if(P.isSunLight){let W=t.get(P);if(W.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Y=P.shadow,tt=e.get(P);tt.shadowIntensity=Y.intensity,tt.shadowBias=Y.bias,tt.shadowNormalBias=Y.normalBias,tt.shadowRadius=Y.radius,tt.shadowMapSize.copy(Y.mapSize).multiply(Y.getFrameExtents()),n.sunShadow[p]=tt,n.sunShadowMap[p]=j;let gt=Y.getViewportCount();for(let wt=0;wt<gt;wt++)n.sunShadowMatrix[x+wt]=Y.getMatrix(wt),n.sunShadowCascade[x+wt]=Y._cascadeData[wt];x+=gt,p++}n.sun[f]=W,f++}else if(P.isDirectionalLight){let W=t.get(P);if(W.color.copy(P.color).multiplyScalar(P.intensity),P.castShadow){let Y=P.shadow,tt=e.get(P);tt.shadowIntensity=Y.intensity,tt.shadowBias=Y.bias,tt.shadowNormalBias=Y.normalBias,tt.shadowRadius=Y.radius,tt.shadowMapSize=Y.mapSize,n.directionalShadow[m]=tt,n.directionalShadowMap[m]=j,n.directionalShadowMatrix[m]=P.shadow.matrix,A++}n.directional[m]=W,m++}else if(P.isSpotLight){let W=t.get(P);W.position.setFromMatrixPosition(P.matrixWorld),W.color.copy(B).multiplyScalar(G),W.distance=H,W.coneCos=Math.cos(P.angle),W.penumbraCos=Math.cos(P.angle*(1-P.penumbra)),W.decay=P.decay,n.spot[y]=W;let Y=P.shadow;if(P.map&&(n.spotLightMap[M]=P.map,M++,Y.updateMatrices(P),P.castShadow&&C++),n.spotLightMatrix[y]=Y.matrix,P.castShadow){let tt=e.get(P);tt.shadowIntensity=Y.intensity,tt.shadowBias=Y.bias,tt.shadowNormalBias=Y.normalBias,tt.shadowRadius=Y.radius,tt.shadowMapSize=Y.mapSize,n.spotShadow[y]=tt,n.spotShadowMap[y]=j,_++}y++}else if(P.isRectAreaLight){let W=t.get(P);W.color.copy(B).multiplyScalar(G),W.halfWidth.set(P.width*.5,0,0),W.halfHeight.set(0,P.height*.5,0),n.rectArea[S]=W,S++}else if(P.isPointLight){let W=t.get(P);if(W.color.copy(P.color).multiplyScalar(P.intensity),W.distance=P.distance,W.decay=P.decay,P.castShadow){let Y=P.shadow,tt=e.get(P);tt.shadowIntensity=Y.intensity,tt.shadowBias=Y.bias,tt.shadowNormalBias=Y.normalBias,tt.shadowRadius=Y.radius,tt.shadowMapSize=Y.mapSize,tt.shadowCameraNear=Y.camera.near,tt.shadowCameraFar=Y.camera.far,n.pointShadow[g]=tt,n.pointShadowMap[g]=j,n.pointShadowMatrix[g]=P.shadow.matrix,w++}n.point[g]=W,g++}else if(P.isHemisphereLight){let W=t.get(P);W.skyColor.copy(P.color).multiplyScalar(G),W.groundColor.copy(P.groundColor).multiplyScalar(G),n.hemi[v]=W,v++}}S>0&&(i.has("OES_texture_float_linear")===!0?(n.rectAreaLTC1=ft.LTC_FLOAT_1,n.rectAreaLTC2=ft.LTC_FLOAT_2):(n.rectAreaLTC1=ft.LTC_HALF_1,n.rectAreaLTC2=ft.LTC_HALF_2)),n.ambient[0]=h,n.ambient[1]=u,n.ambient[2]=d;let L=n.hash;(L.sunLength!==f||L.directionalLength!==m||L.pointLength!==g||L.spotLength!==y||L.rectAreaLength!==S||L.hemiLength!==v||L.numSunShadows!==p||L.numDirectionalShadows!==A||L.numPointShadows!==w||L.numSpotShadows!==_||L.numSpotMaps!==M||L.numLightProbes!==T)&&(n.sun.length=f,n.directional.length=m,n.spot.length=y,n.rectArea.length=S,n.point.length=g,n.hemi.length=v,n.sunShadow.length=p,n.sunShadowMap.length=p,n.sunShadowMatrix.length=x,n.sunShadowCascade.length=x,n.directionalShadow.length=A,n.directionalShadowMap.length=A,n.directionalShadowMatrix.length=A,n.pointShadow.length=w,n.pointShadowMap.length=w,n.pointShadowMatrix.length=w,n.spotShadow.length=_,n.spotShadowMap.length=_,n.spotLightMatrix.length=_+M-C,n.spotLightMap.length=M,n.numSpotLightShadowsWithMaps=C,n.numLightProbes=T,L.sunLength=f,L.directionalLength=m,L.pointLength=g,L.spotLength=y,L.rectAreaLength=S,L.hemiLength=v,L.numSunShadows=p,L.numDirectionalShadows=A,L.numPointShadows=w,L.numSpotShadows=_,L.numSpotMaps=M,L.numLightProbes=T,n.version=_M++)}function c(l,h){let u=0,d=0,f=0,p=0,x=0,m=0,g=h.matrixWorldInverse;for(let y=0,S=l.length;y<S;y++){let v=l[y];if(v.isSunLight){let A=n.sun[u];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),u++}else if(v.isDirectionalLight){let A=n.directional[d];A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),d++}else if(v.isSpotLight){let A=n.spot[p];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),A.direction.setFromMatrixPosition(v.matrixWorld),s.setFromMatrixPosition(v.target.matrixWorld),A.direction.sub(s),A.direction.transformDirection(g),p++}else if(v.isRectAreaLight){let A=n.rectArea[x];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),o.identity(),r.copy(v.matrixWorld),r.premultiply(g),o.extractRotation(r),A.halfWidth.set(v.width*.5,0,0),A.halfHeight.set(0,v.height*.5,0),A.halfWidth.applyMatrix4(o),A.halfHeight.applyMatrix4(o),x++}else if(v.isPointLight){let A=n.point[f];A.position.setFromMatrixPosition(v.matrixWorld),A.position.applyMatrix4(g),f++}else if(v.isHemisphereLight){let A=n.hemi[m];A.direction.setFromMatrixPosition(v.matrixWorld),A.direction.transformDirection(g),m++}}}return{setup:a,setupView:c,state:n}}function xp(i){let t=new vM(i),e=[],n=[],s=[];function r(u){h.camera=u,e.length=0,n.length=0,s.length=0}function o(u){u.isLightProbeGrid?s.push(u):e.push(u)}function a(u){n.push(u)}function c(){t.setup(e),s.sort((u,d)=>u.priority-d.priority||u.id-d.id)}function l(u){t.setupView(e,u)}let h={lightsArray:e,shadowsArray:n,lightProbeGridArray:s,camera:null,lights:t,transmissionRenderTarget:{},textureUnits:0};return{init:r,state:h,setupLights:c,setupLightsView:l,pushLight:o,pushShadow:a}}function MM(i){let t=new WeakMap;function e(s,r=0){let o=t.get(s),a;return o===void 0?(a=new xp(i),t.set(s,[a])):r>=o.length?(a=new xp(i),o.push(a)):a=o[r],a}function n(){t=new WeakMap}return{get:e,dispose:n}}var SM=`void main() {
	gl_Position = vec4( position, 1.0 );
}`,bM=`uniform sampler2D shadow_pass;
uniform vec2 resolution;
uniform float radius;
void main() {
	const float samples = float( VSM_SAMPLES );
	float mean = 0.0;
	float squared_mean = 0.0;
	float uvStride = samples <= 1.0 ? 0.0 : 2.0 / ( samples - 1.0 );
	float uvStart = samples <= 1.0 ? 0.0 : - 1.0;
	for ( float i = 0.0; i < samples; i ++ ) {
		float uvOffset = uvStart + i * uvStride;
		#ifdef HORIZONTAL_PASS
			vec2 distribution = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( uvOffset, 0.0 ) * radius ) / resolution ).rg;
			mean += distribution.x;
			squared_mean += distribution.y * distribution.y + distribution.x * distribution.x;
		#else
			float depth = texture2D( shadow_pass, ( gl_FragCoord.xy + vec2( 0.0, uvOffset ) * radius ) / resolution ).r;
			mean += depth;
			squared_mean += depth * depth;
		#endif
	}
	mean = mean / samples;
	squared_mean = squared_mean / samples;
	float std_dev = sqrt( max( 0.0, squared_mean - mean * mean ) );
	gl_FragColor = vec4( mean, std_dev, 0.0, 1.0 );
}`,wM=[new I(1,0,0),new I(-1,0,0),new I(0,1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1)],AM=[new I(0,-1,0),new I(0,-1,0),new I(0,0,1),new I(0,0,-1),new I(0,-1,0),new I(0,-1,0)],_p=new te,Fo=new I,Mu=new I;function EM(i,t,e){let n=new Ki,s=new Wt,r=new Wt,o=new ce,a=new oc,c=new ac,l={},h=e.maxTextureSize,u={[ss]:un,[un]:ss,[hi]:hi},d=new kn({defines:{VSM_SAMPLES:8},uniforms:{shadow_pass:{value:null},resolution:{value:new Wt},radius:{value:4}},vertexShader:SM,fragmentShader:bM}),f=d.clone();f.defines.HORIZONTAL_PASS=1;let p=new Ee;p.setAttribute("position",new De(new Float32Array([-1,-1,.5,3,-1,.5,-1,3,.5]),3));let x=new ee(p,d),m=this;this.enabled=!1,this.autoUpdate=!0,this.needsUpdate=!1,this.type=Ro;let g=this.type;this.render=function(w,_,M){if(m.enabled===!1||m.autoUpdate===!1&&m.needsUpdate===!1||w.length===0)return;this.type===mf&&(It("WebGLShadowMap: PCFSoftShadowMap has been removed. Using PCFShadowMap instead."),this.type=Ro);let C=i.getRenderTarget(),T=i.getActiveCubeFace(),L=i.getActiveMipmapLevel(),N=i.state;N.setBlending(Ns),N.buffers.depth.getReversed()===!0?N.buffers.color.setClear(0,0,0,0):N.buffers.color.setClear(1,1,1,1),N.buffers.depth.setTest(!0),N.setScissorTest(!1);let F=g!==this.type;F&&_.traverse(function(P){P.material&&(Array.isArray(P.material)?P.material.forEach(B=>B.needsUpdate=!0):P.material.needsUpdate=!0)});for(let P=0,B=w.length;P<B;P++){let G=w[P],H=G.shadow;if(H===void 0){It("WebGLShadowMap:",G,"has no shadow.");continue}if(H.autoUpdate===!1&&H.needsUpdate===!1)continue;s.copy(H.mapSize);let j=H.getFrameExtents();s.multiply(j),r.copy(H.mapSize),(s.x>h||s.y>h)&&(s.x>h&&(r.x=Math.floor(h/j.x),s.x=r.x*j.x,H.mapSize.x=r.x),s.y>h&&(r.y=Math.floor(h/j.y),s.y=r.y*j.y,H.mapSize.y=r.y));let W=i.state.buffers.depth.getReversed();if(H.camera._reversedDepth=W,H.map===null||F===!0){if(H.map!==null&&(H.map.depthTexture!==null&&(H.map.depthTexture.dispose(),H.map.depthTexture=null),H.map.dispose()),this.type===_r){if(G.isPointLight){It("WebGLShadowMap: VSM shadow maps are not supported for PointLights. Use PCF or BasicShadowMap instead.");continue}H.map=new An(s.x,s.y,{format:rs,type:Qn,minFilter:Oe,magFilter:Oe,generateMipmaps:!1}),H.map.texture.name=G.name+".shadowMap",H.map.depthTexture=new Li(s.x,s.y,Gn),H.map.depthTexture.name=G.name+".shadowMapDepth",H.map.depthTexture.format=Ci,H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=He,H.map.depthTexture.magFilter=He}else G.isPointLight?(H.map=new zo(s.x),H.map.depthTexture=new go(s.x,jn)):(H.map=new An(s.x,s.y),H.map.depthTexture=new Li(s.x,s.y,jn)),H.map.depthTexture.name=G.name+".shadowMap",H.map.depthTexture.format=Ci,this.type===Ro?(H.map.depthTexture.compareFunction=W?cu:au,H.map.depthTexture.minFilter=Oe,H.map.depthTexture.magFilter=Oe):(H.map.depthTexture.compareFunction=null,H.map.depthTexture.minFilter=He,H.map.depthTexture.magFilter=He);H.camera.updateProjectionMatrix()}H.map.isWebGLCubeRenderTarget!==!0&&(H.map.width!==s.x||H.map.height!==s.y)&&H.map.setSize(s.x,s.y);let Y=H.map.isWebGLCubeRenderTarget?6:H.getViewportCount();G.isPointLight!==!0&&H.updateMatrices(G,M);let tt=(H.camera.layers.mask&4294967294)!==0?H.camera.layers:M.layers;for(let gt=0;gt<Y;gt++){let wt=H.getCamera(gt);if(G.isPointLight){let X=H.camera,rt=H.matrix,xt=G.distance||X.far;xt!==X.far&&(X.far=xt,X.updateProjectionMatrix()),Fo.setFromMatrixPosition(G.matrixWorld),X.position.copy(Fo),Mu.copy(X.position),Mu.add(wM[gt]),X.up.copy(AM[gt]),X.lookAt(Mu),X.updateMatrixWorld(),rt.makeTranslation(-Fo.x,-Fo.y,-Fo.z),_p.multiplyMatrices(X.projectionMatrix,X.matrixWorldInverse),H._frustum.setFromProjectionMatrix(_p,X.coordinateSystem,X.reversedDepth)}if(H.map.isWebGLCubeRenderTarget)i.setRenderTarget(H.map,gt),i.clear();else{gt===0&&(i.setRenderTarget(H.map),i.clear());let X=H.getViewport(gt);o.set(r.x*X.x,r.y*X.y,r.x*X.z,r.y*X.w),N.viewport(o)}n=H.getFrustum(gt),v(_,M,wt,G,tt,this.type)}H.isPointLightShadow!==!0&&this.type===_r&&y(H,M),H.needsUpdate=!1}g=this.type,m.needsUpdate=!1,i.setRenderTarget(C,T,L)};function y(w,_){let M=t.update(x);d.defines.VSM_SAMPLES!==w.blurSamples&&(d.defines.VSM_SAMPLES=w.blurSamples,f.defines.VSM_SAMPLES=w.blurSamples,d.needsUpdate=!0,f.needsUpdate=!0),w.mapPass===null?w.mapPass=new An(s.x,s.y,{format:rs,type:Qn}):(w.mapPass.width!==w.map.width||w.mapPass.height!==w.map.height)&&w.mapPass.setSize(w.map.width,w.map.height),d.uniforms.shadow_pass.value=w.map.depthTexture,d.uniforms.resolution.value.set(w.map.width,w.map.height),d.uniforms.radius.value=w.radius,i.setRenderTarget(w.mapPass),i.clear(),i.renderBufferDirect(_,null,M,d,x,null),f.uniforms.shadow_pass.value=w.mapPass.texture,f.uniforms.resolution.value.set(w.map.width,w.map.height),f.uniforms.radius.value=w.radius,i.setRenderTarget(w.map),i.clear(),i.renderBufferDirect(_,null,M,f,x,null)}function S(w,_,M,C){let T=null,L=M.isPointLight===!0?w.customDistanceMaterial:w.customDepthMaterial;if(L!==void 0)T=L;else if(T=M.isPointLight===!0?c:a,i.localClippingEnabled&&_.clipShadows===!0&&Array.isArray(_.clippingPlanes)&&_.clippingPlanes.length!==0||_.displacementMap&&_.displacementScale!==0||_.alphaMap&&_.alphaTest>0||_.map&&_.alphaTest>0||_.alphaToCoverage===!0){let N=T.uuid,F=_.uuid,P=l[N];P===void 0&&(P={},l[N]=P);let B=P[F];B===void 0&&(B=T.clone(),P[F]=B,_.addEventListener("dispose",A)),T=B}if(T.visible=_.visible,T.wireframe=_.wireframe,C===_r?T.side=_.shadowSide!==null?_.shadowSide:_.side:T.side=_.shadowSide!==null?_.shadowSide:u[_.side],T.alphaMap=_.alphaMap,T.alphaTest=_.alphaToCoverage===!0?.5:_.alphaTest,T.map=_.map,T.clipShadows=_.clipShadows,T.clippingPlanes=_.clippingPlanes,T.clipIntersection=_.clipIntersection,T.displacementMap=_.displacementMap,T.displacementScale=_.displacementScale,T.displacementBias=_.displacementBias,T.wireframeLinewidth=_.wireframeLinewidth,T.linewidth=_.linewidth,M.isPointLight===!0&&T.isMeshDistanceMaterial===!0){let N=i.properties.get(T);N.light=M}return T}function v(w,_,M,C,T,L){if(w.visible===!1)return;if(w.layers.test(T)&&(w.isMesh||w.isLine||w.isPoints)&&(w.castShadow||w.receiveShadow&&L===_r)&&(!w.frustumCulled||w.intersectsFrustum(n))){w.modelViewMatrix.multiplyMatrices(M.matrixWorldInverse,w.matrixWorld);let P=t.update(w),B=w.material;if(Array.isArray(B)){let G=P.groups;for(let H=0,j=G.length;H<j;H++){let W=G[H],Y=B[W.materialIndex];if(Y&&Y.visible){let tt=S(w,Y,C,L);w.onBeforeShadow(i,w,_,M,P,tt,W),i.renderBufferDirect(M,null,P,tt,w,W),w.onAfterShadow(i,w,_,M,P,tt,W)}}}else if(B.visible){let G=S(w,B,C,L);w.onBeforeShadow(i,w,_,M,P,G,null),i.renderBufferDirect(M,null,P,G,w,null),w.onAfterShadow(i,w,_,M,P,G,null)}}let F=w.children;for(let P=0,B=F.length;P<B;P++)v(F[P],_,M,C,T,L)}function A(w){w.target.removeEventListener("dispose",A);for(let M in l){let C=l[M],T=w.target.uuid;T in C&&(C[T].dispose(),delete C[T])}}}function TM(i,t){function e(){let D=!1,K=new ce,$=null,lt=new ce(0,0,0,0);return{setMask:function(it){$!==it&&!D&&(i.colorMask(it,it,it,it),$=it)},setLocked:function(it){D=it},setClear:function(it,at,Ct,qt,nt){nt===!0&&(it*=qt,at*=qt,Ct*=qt),K.set(it,at,Ct,qt),lt.equals(K)===!1&&(i.clearColor(it,at,Ct,qt),lt.copy(K))},reset:function(){D=!1,$=null,lt.set(-1,0,0,0)}}}function n(){let D=!1,K=!1,$=null,lt=null,it=null;return{setReversed:function(at){if(K!==at){let Ct=t.get("EXT_clip_control");at?Ct.clipControlEXT(Ct.LOWER_LEFT_EXT,Ct.ZERO_TO_ONE_EXT):Ct.clipControlEXT(Ct.LOWER_LEFT_EXT,Ct.NEGATIVE_ONE_TO_ONE_EXT),K=at;let qt=it;it=null,this.setClear(qt)}},getReversed:function(){return K},setTest:function(at){at?pt(i.DEPTH_TEST):Dt(i.DEPTH_TEST)},setMask:function(at){$!==at&&!D&&(i.depthMask(at),$=at)},setFunc:function(at){if(K&&(at=Yf[at]),lt!==at){switch(at){case Va:i.depthFunc(i.NEVER);break;case Ha:i.depthFunc(i.ALWAYS);break;case Wa:i.depthFunc(i.LESS);break;case or:i.depthFunc(i.LEQUAL);break;case qa:i.depthFunc(i.EQUAL);break;case Xa:i.depthFunc(i.GEQUAL);break;case $a:i.depthFunc(i.GREATER);break;case Ya:i.depthFunc(i.NOTEQUAL);break;default:i.depthFunc(i.LEQUAL)}lt=at}},setLocked:function(at){D=at},setClear:function(at){it!==at&&(it=at,K&&(at=1-at),i.clearDepth(at))},reset:function(){D=!1,$=null,lt=null,it=null,K=!1}}}function s(){let D=!1,K=null,$=null,lt=null,it=null,at=null,Ct=null,qt=null,nt=null;return{setTest:function(Pt){D||(Pt?pt(i.STENCIL_TEST):Dt(i.STENCIL_TEST))},setMask:function(Pt){K!==Pt&&!D&&(i.stencilMask(Pt),K=Pt)},setFunc:function(Pt,Ht,_t){($!==Pt||lt!==Ht||it!==_t)&&(i.stencilFunc(Pt,Ht,_t),$=Pt,lt=Ht,it=_t)},setOp:function(Pt,Ht,_t){(at!==Pt||Ct!==Ht||qt!==_t)&&(i.stencilOp(Pt,Ht,_t),at=Pt,Ct=Ht,qt=_t)},setLocked:function(Pt){D=Pt},setClear:function(Pt){nt!==Pt&&(i.clearStencil(Pt),nt=Pt)},reset:function(){D=!1,K=null,$=null,lt=null,it=null,at=null,Ct=null,qt=null,nt=null}}}let r=new e,o=new n,a=new s,c={},l=new WeakMap,h={},u={},d={},f=new WeakMap,p=[],x=null,m=!1,g=null,y=null,S=null,v=null,A=null,w=null,_=null,M=new zt(0,0,0),C=0,T=!1,L=null,N=null,F=null,P=null,B=null,G=i.getParameter(i.MAX_COMBINED_TEXTURE_IMAGE_UNITS),H=!1,j=0,W=i.getParameter(i.VERSION);W.indexOf("WebGL")!==-1?(j=parseFloat(/^WebGL (\d)/.exec(W)[1]),H=j>=1):W.indexOf("OpenGL ES")!==-1&&(j=parseFloat(/^OpenGL ES (\d)/.exec(W)[1]),H=j>=2);let Y=null,tt={},gt=i.getParameter(i.SCISSOR_BOX),wt=i.getParameter(i.VIEWPORT),X=new ce().fromArray(gt),rt=new ce().fromArray(wt);function xt(D,K,$,lt){let it=new Uint8Array(4),at=i.createTexture();i.bindTexture(D,at),i.texParameteri(D,i.TEXTURE_MIN_FILTER,i.NEAREST),i.texParameteri(D,i.TEXTURE_MAG_FILTER,i.NEAREST);for(let Ct=0;Ct<$;Ct++)D===i.TEXTURE_3D||D===i.TEXTURE_2D_ARRAY?i.texImage3D(K,0,i.RGBA,1,1,lt,0,i.RGBA,i.UNSIGNED_BYTE,it):i.texImage2D(K+Ct,0,i.RGBA,1,1,0,i.RGBA,i.UNSIGNED_BYTE,it);return at}let At={};At[i.TEXTURE_2D]=xt(i.TEXTURE_2D,i.TEXTURE_2D,1),At[i.TEXTURE_CUBE_MAP]=xt(i.TEXTURE_CUBE_MAP,i.TEXTURE_CUBE_MAP_POSITIVE_X,6),At[i.TEXTURE_2D_ARRAY]=xt(i.TEXTURE_2D_ARRAY,i.TEXTURE_2D_ARRAY,1,1),At[i.TEXTURE_3D]=xt(i.TEXTURE_3D,i.TEXTURE_3D,1,1),r.setClear(0,0,0,1),o.setClear(1),a.setClear(0),pt(i.DEPTH_TEST),o.setFunc(or),ie(!1),pe(Gh),pt(i.CULL_FACE),we(Ns);function pt(D){h[D]!==!0&&(i.enable(D),h[D]=!0)}function Dt(D){h[D]!==!1&&(i.disable(D),h[D]=!1)}function fe(D,K){return d[D]!==K?(i.bindFramebuffer(D,K),d[D]=K,D===i.DRAW_FRAMEBUFFER&&(d[i.FRAMEBUFFER]=K),D===i.FRAMEBUFFER&&(d[i.DRAW_FRAMEBUFFER]=K),!0):!1}function Rt(D,K){let $=p,lt=!1;if(D){$=f.get(K),$===void 0&&($=[],f.set(K,$));let it=D.textures;if($.length!==it.length||$[0]!==i.COLOR_ATTACHMENT0){for(let at=0,Ct=it.length;at<Ct;at++)$[at]=i.COLOR_ATTACHMENT0+at;$.length=it.length,lt=!0}}else $[0]!==i.BACK&&($[0]=i.BACK,lt=!0);lt&&i.drawBuffers($)}function Yt(D){return x!==D?(i.useProgram(D),x=D,!0):!1}let jt={[Ds]:i.FUNC_ADD,[xf]:i.FUNC_SUBTRACT,[_f]:i.FUNC_REVERSE_SUBTRACT};jt[yf]=i.MIN,jt[vf]=i.MAX;let kt={[Mf]:i.ZERO,[Sf]:i.ONE,[bf]:i.SRC_COLOR,[qh]:i.SRC_ALPHA,[Cf]:i.SRC_ALPHA_SATURATE,[Tf]:i.DST_COLOR,[Af]:i.DST_ALPHA,[wf]:i.ONE_MINUS_SRC_COLOR,[Xh]:i.ONE_MINUS_SRC_ALPHA,[Rf]:i.ONE_MINUS_DST_COLOR,[Ef]:i.ONE_MINUS_DST_ALPHA,[Pf]:i.CONSTANT_COLOR,[If]:i.ONE_MINUS_CONSTANT_COLOR,[Lf]:i.CONSTANT_ALPHA,[Nf]:i.ONE_MINUS_CONSTANT_ALPHA};function we(D,K,$,lt,it,at,Ct,qt,nt,Pt){if(D===Ns){m===!0&&(Dt(i.BLEND),m=!1);return}if(m===!1&&(pt(i.BLEND),m=!0),D!==gf){if(D!==g||Pt!==T){if((y!==Ds||A!==Ds)&&(i.blendEquation(i.FUNC_ADD),y=Ds,A=Ds),Pt)switch(D){case yr:i.blendFuncSeparate(i.ONE,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vh:i.blendFunc(i.ONE,i.ONE);break;case Hh:i.blendFuncSeparate(i.ZERO,i.ONE_MINUS_SRC_COLOR,i.ZERO,i.ONE);break;case Wh:i.blendFuncSeparate(i.DST_COLOR,i.ONE_MINUS_SRC_ALPHA,i.ZERO,i.ONE);break;default:Ut("WebGLState: Invalid blending: ",D);break}else switch(D){case yr:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE_MINUS_SRC_ALPHA,i.ONE,i.ONE_MINUS_SRC_ALPHA);break;case Vh:i.blendFuncSeparate(i.SRC_ALPHA,i.ONE,i.ONE,i.ONE);break;case Hh:Ut("WebGLState: SubtractiveBlending requires material.premultipliedAlpha = true");break;case Wh:Ut("WebGLState: MultiplyBlending requires material.premultipliedAlpha = true");break;default:Ut("WebGLState: Invalid blending: ",D);break}S=null,v=null,w=null,_=null,M.set(0,0,0),C=0,g=D,T=Pt}return}it=it||K,at=at||$,Ct=Ct||lt,(K!==y||it!==A)&&(i.blendEquationSeparate(jt[K],jt[it]),y=K,A=it),($!==S||lt!==v||at!==w||Ct!==_)&&(i.blendFuncSeparate(kt[$],kt[lt],kt[at],kt[Ct]),S=$,v=lt,w=at,_=Ct),(qt.equals(M)===!1||nt!==C)&&(i.blendColor(qt.r,qt.g,qt.b,nt),M.copy(qt),C=nt),g=D,T=!1}function xe(D,K){D.side===hi?Dt(i.CULL_FACE):pt(i.CULL_FACE);let $=D.side===un;K&&($=!$),ie($),D.blending===yr&&D.transparent===!1?we(Ns):we(D.blending,D.blendEquation,D.blendSrc,D.blendDst,D.blendEquationAlpha,D.blendSrcAlpha,D.blendDstAlpha,D.blendColor,D.blendAlpha,D.premultipliedAlpha),o.setFunc(D.depthFunc),o.setTest(D.depthTest),o.setMask(D.depthWrite),r.setMask(D.colorWrite);let lt=D.stencilWrite;a.setTest(lt),lt&&(a.setMask(D.stencilWriteMask),a.setFunc(D.stencilFunc,D.stencilRef,D.stencilFuncMask),a.setOp(D.stencilFail,D.stencilZFail,D.stencilZPass)),Ce(D.polygonOffset,D.polygonOffsetFactor,D.polygonOffsetUnits),D.alphaToCoverage===!0?pt(i.SAMPLE_ALPHA_TO_COVERAGE):Dt(i.SAMPLE_ALPHA_TO_COVERAGE)}function ie(D){L!==D&&(D?i.frontFace(i.CW):i.frontFace(i.CCW),L=D)}function pe(D){D!==ff?(pt(i.CULL_FACE),D!==N&&(D===Gh?i.cullFace(i.BACK):D===pf?i.cullFace(i.FRONT):i.cullFace(i.FRONT_AND_BACK))):Dt(i.CULL_FACE),N=D}function Mn(D){D!==F&&(H&&i.lineWidth(D),F=D)}function Ce(D,K,$){D?(pt(i.POLYGON_OFFSET_FILL),(P!==K||B!==$)&&(P=K,B=$,o.getReversed()&&(K=-K,$=-$),i.polygonOffset(K,$))):Dt(i.POLYGON_OFFSET_FILL)}function rn(D){D?pt(i.SCISSOR_TEST):Dt(i.SCISSOR_TEST)}function Dn(D){D===void 0&&(D=i.TEXTURE0+G-1),Y!==D&&(i.activeTexture(D),Y=D)}function Un(D,K,$){$===void 0&&(Y===null?$=i.TEXTURE0+G-1:$=Y);let lt=tt[$];lt===void 0&&(lt={type:void 0,texture:void 0},tt[$]=lt),(lt.type!==D||lt.texture!==K)&&(Y!==$&&(i.activeTexture($),Y=$),i.bindTexture(D,K||At[D]),lt.type=D,lt.texture=K)}function O(){let D=tt[Y];D!==void 0&&D.type!==void 0&&(i.bindTexture(D.type,null),D.type=void 0,D.texture=void 0)}function On(){try{i.compressedTexImage2D(...arguments)}catch(D){Ut("WebGLState:",D)}}function ve(){try{i.compressedTexImage3D(...arguments)}catch(D){Ut("WebGLState:",D)}}function Me(){try{i.texSubImage2D(...arguments)}catch(D){Ut("WebGLState:",D)}}function mt(){try{i.texSubImage3D(...arguments)}catch(D){Ut("WebGLState:",D)}}function Ue(){try{i.compressedTexSubImage2D(...arguments)}catch(D){Ut("WebGLState:",D)}}function Lt(){try{i.compressedTexSubImage3D(...arguments)}catch(D){Ut("WebGLState:",D)}}function Ft(){try{i.texStorage2D(...arguments)}catch(D){Ut("WebGLState:",D)}}function R(){try{i.texStorage3D(...arguments)}catch(D){Ut("WebGLState:",D)}}function b(){try{i.texImage2D(...arguments)}catch(D){Ut("WebGLState:",D)}}function k(){try{i.texImage3D(...arguments)}catch(D){Ut("WebGLState:",D)}}function et(D){return u[D]!==void 0?u[D]:i.getParameter(D)}function Q(D,K){u[D]!==K&&(i.pixelStorei(D,K),u[D]=K)}function ot(D){X.equals(D)===!1&&(i.scissor(D.x,D.y,D.z,D.w),X.copy(D))}function ut(D){rt.equals(D)===!1&&(i.viewport(D.x,D.y,D.z,D.w),rt.copy(D))}function Z(D,K){let $=l.get(K);$===void 0&&($=new WeakMap,l.set(K,$));let lt=$.get(D);lt===void 0&&(lt=i.getUniformBlockIndex(K,D.name),i.uniformBlockBinding(K,lt,lt),$.set(D,lt))}function J(D,K,$){let it=l.get(K).get(D);c[it]!==$&&(i.bindBufferBase(i.UNIFORM_BUFFER,it,$),c[it]=$)}function ct(){i.disable(i.BLEND),i.disable(i.CULL_FACE),i.disable(i.DEPTH_TEST),i.disable(i.POLYGON_OFFSET_FILL),i.disable(i.SCISSOR_TEST),i.disable(i.STENCIL_TEST),i.disable(i.SAMPLE_ALPHA_TO_COVERAGE),i.blendEquation(i.FUNC_ADD),i.blendFunc(i.ONE,i.ZERO),i.blendFuncSeparate(i.ONE,i.ZERO,i.ONE,i.ZERO),i.blendColor(0,0,0,0),i.colorMask(!0,!0,!0,!0),i.clearColor(0,0,0,0),i.depthMask(!0),i.depthFunc(i.LESS),o.setReversed(!1),i.clearDepth(1),i.stencilMask(4294967295),i.stencilFunc(i.ALWAYS,0,4294967295),i.stencilOp(i.KEEP,i.KEEP,i.KEEP),i.clearStencil(0),i.cullFace(i.BACK),i.frontFace(i.CCW),i.polygonOffset(0,0),i.activeTexture(i.TEXTURE0),i.bindFramebuffer(i.FRAMEBUFFER,null),i.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),i.bindFramebuffer(i.READ_FRAMEBUFFER,null),i.useProgram(null),i.lineWidth(1),i.scissor(0,0,i.canvas.width,i.canvas.height),i.viewport(0,0,i.canvas.width,i.canvas.height),i.pixelStorei(i.PACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_ALIGNMENT,4),i.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,!1),i.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,!1),i.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,i.BROWSER_DEFAULT_WEBGL),i.pixelStorei(i.PACK_ROW_LENGTH,0),i.pixelStorei(i.PACK_SKIP_PIXELS,0),i.pixelStorei(i.PACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_ROW_LENGTH,0),i.pixelStorei(i.UNPACK_IMAGE_HEIGHT,0),i.pixelStorei(i.UNPACK_SKIP_PIXELS,0),i.pixelStorei(i.UNPACK_SKIP_ROWS,0),i.pixelStorei(i.UNPACK_SKIP_IMAGES,0),h={},u={},Y=null,tt={},d={},c={},f=new WeakMap,p=[],x=null,m=!1,g=null,y=null,S=null,v=null,A=null,w=null,_=null,M=new zt(0,0,0),C=0,T=!1,L=null,N=null,F=null,P=null,B=null,X.set(0,0,i.canvas.width,i.canvas.height),rt.set(0,0,i.canvas.width,i.canvas.height),r.reset(),o.reset(),a.reset()}return{buffers:{color:r,depth:o,stencil:a},enable:pt,disable:Dt,bindFramebuffer:fe,drawBuffers:Rt,useProgram:Yt,setBlending:we,setMaterial:xe,setFlipSided:ie,setCullFace:pe,setLineWidth:Mn,setPolygonOffset:Ce,setScissorTest:rn,activeTexture:Dn,bindTexture:Un,unbindTexture:O,compressedTexImage2D:On,compressedTexImage3D:ve,texImage2D:b,texImage3D:k,pixelStorei:Q,getParameter:et,updateUBOMapping:Z,uniformBlockBinding:J,texStorage2D:Ft,texStorage3D:R,texSubImage2D:Me,texSubImage3D:mt,compressedTexSubImage2D:Ue,compressedTexSubImage3D:Lt,scissor:ot,viewport:ut,reset:ct}}function RM(i,t,e,n,s,r,o){let a=t.has("WEBGL_multisampled_render_to_texture")?t.get("WEBGL_multisampled_render_to_texture"):null,c=typeof navigator>"u"?!1:/OculusBrowser/g.test(navigator.userAgent),l=new Wt,h=new WeakMap,u=new Set,d,f=new WeakMap,p=new Set,x=new FinalizationRegistry(R=>p.delete(R)),m=!1;try{m=typeof OffscreenCanvas<"u"&&new OffscreenCanvas(1,1).getContext("2d")!==null}catch{}function g(R,b){return m?new OffscreenCanvas(R,b):so("canvas")}function y(R,b,k){let et=1,Q=Ft(R);if((Q.width>k||Q.height>k)&&(et=k/Math.max(Q.width,Q.height)),et<1)if(typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement||typeof HTMLCanvasElement<"u"&&R instanceof HTMLCanvasElement||typeof ImageBitmap<"u"&&R instanceof ImageBitmap||typeof VideoFrame<"u"&&R instanceof VideoFrame){let ot=Math.floor(et*Q.width),ut=Math.floor(et*Q.height);d===void 0&&(d=g(ot,ut));let Z=b?g(ot,ut):d;return Z.width=ot,Z.height=ut,Z.getContext("2d").drawImage(R,0,0,ot,ut),It("WebGLRenderer: Texture has been resized from ("+Q.width+"x"+Q.height+") to ("+ot+"x"+ut+")."),Z}else return"data"in R&&It("WebGLRenderer: Image in DataTexture is too big ("+Q.width+"x"+Q.height+")."),R;return R}function S(R){return R.generateMipmaps}function v(R){i.generateMipmap(R)}function A(R){return R.isWebGLCubeRenderTarget?i.TEXTURE_CUBE_MAP:R.isWebGL3DRenderTarget?i.TEXTURE_3D:R.isWebGLArrayRenderTarget||R.isCompressedArrayTexture?i.TEXTURE_2D_ARRAY:i.TEXTURE_2D}function w(R,b,k,et,Q,ot=!1){if(R!==null){if(i[R]!==void 0)return i[R];It("WebGLRenderer: Attempt to use non-existing WebGL internal format '"+R+"'")}let ut;et&&(ut=t.get("EXT_texture_norm16"),ut||It("WebGLRenderer: Unable to use normalized textures without EXT_texture_norm16 extension"));let Z=b;if(b===i.RED&&(k===i.FLOAT&&(Z=i.R32F),k===i.HALF_FLOAT&&(Z=i.R16F),k===i.UNSIGNED_BYTE&&(Z=i.R8),k===i.UNSIGNED_SHORT&&ut&&(Z=ut.R16_EXT),k===i.SHORT&&ut&&(Z=ut.R16_SNORM_EXT)),b===i.RED_INTEGER&&(k===i.UNSIGNED_BYTE&&(Z=i.R8UI),k===i.UNSIGNED_SHORT&&(Z=i.R16UI),k===i.UNSIGNED_INT&&(Z=i.R32UI),k===i.BYTE&&(Z=i.R8I),k===i.SHORT&&(Z=i.R16I),k===i.INT&&(Z=i.R32I)),b===i.RG&&(k===i.FLOAT&&(Z=i.RG32F),k===i.HALF_FLOAT&&(Z=i.RG16F),k===i.UNSIGNED_BYTE&&(Z=i.RG8),k===i.UNSIGNED_SHORT&&ut&&(Z=ut.RG16_EXT),k===i.SHORT&&ut&&(Z=ut.RG16_SNORM_EXT)),b===i.RG_INTEGER&&(k===i.UNSIGNED_BYTE&&(Z=i.RG8UI),k===i.UNSIGNED_SHORT&&(Z=i.RG16UI),k===i.UNSIGNED_INT&&(Z=i.RG32UI),k===i.BYTE&&(Z=i.RG8I),k===i.SHORT&&(Z=i.RG16I),k===i.INT&&(Z=i.RG32I)),b===i.RGB_INTEGER&&(k===i.UNSIGNED_BYTE&&(Z=i.RGB8UI),k===i.UNSIGNED_SHORT&&(Z=i.RGB16UI),k===i.UNSIGNED_INT&&(Z=i.RGB32UI),k===i.BYTE&&(Z=i.RGB8I),k===i.SHORT&&(Z=i.RGB16I),k===i.INT&&(Z=i.RGB32I)),b===i.RGBA_INTEGER&&(k===i.UNSIGNED_BYTE&&(Z=i.RGBA8UI),k===i.UNSIGNED_SHORT&&(Z=i.RGBA16UI),k===i.UNSIGNED_INT&&(Z=i.RGBA32UI),k===i.BYTE&&(Z=i.RGBA8I),k===i.SHORT&&(Z=i.RGBA16I),k===i.INT&&(Z=i.RGBA32I)),b===i.RGB&&(k===i.UNSIGNED_SHORT&&ut&&(Z=ut.RGB16_EXT),k===i.SHORT&&ut&&(Z=ut.RGB16_SNORM_EXT),k===i.UNSIGNED_INT_5_9_9_9_REV&&(Z=i.RGB9_E5),k===i.UNSIGNED_INT_10F_11F_11F_REV&&(Z=i.R11F_G11F_B10F)),b===i.RGBA){let J=ot?io:Kt.getTransfer(Q);k===i.FLOAT&&(Z=i.RGBA32F),k===i.HALF_FLOAT&&(Z=i.RGBA16F),k===i.UNSIGNED_BYTE&&(Z=J===oe?i.SRGB8_ALPHA8:i.RGBA8),k===i.UNSIGNED_SHORT&&ut&&(Z=ut.RGBA16_EXT),k===i.SHORT&&ut&&(Z=ut.RGBA16_SNORM_EXT),k===i.UNSIGNED_SHORT_4_4_4_4&&(Z=i.RGBA4),k===i.UNSIGNED_SHORT_5_5_5_1&&(Z=i.RGB5_A1)}return(Z===i.R16F||Z===i.R32F||Z===i.RG16F||Z===i.RG32F||Z===i.RGBA16F||Z===i.RGBA32F)&&t.get("EXT_color_buffer_float"),Z}function _(R,b){let k;return R?b===null||b===jn||b===Os?k=i.DEPTH24_STENCIL8:b===Gn?k=i.DEPTH32F_STENCIL8:b===Mr&&(k=i.DEPTH24_STENCIL8,It("DepthTexture: 16 bit depth attachment is not supported with stencil. Using 24-bit attachment.")):b===null||b===jn||b===Os?k=i.DEPTH_COMPONENT24:b===Gn?k=i.DEPTH_COMPONENT32F:b===Mr&&(k=i.DEPTH_COMPONENT16),k}function M(R,b){return S(R)===!0||R.isFramebufferTexture&&R.minFilter!==He&&R.minFilter!==Oe?Math.log2(Math.max(b.width,b.height))+1:R.mipmaps.length>0?R.mipmaps.length:R.isCompressedTexture&&Array.isArray(R.image)?b.mipmaps.length:1}function C(R){let b=new WeakRef(R);n.get(R).__ref=b,p.add(b),x.register(R,b,b)}function T(R){let b=n.get(R).__ref;b!==void 0&&(p.delete(b),x.unregister(b))}function L(R){F(R.target)}function N(R){P(R.target)}function F(R){R.removeEventListener("dispose",L),T(R),G(R),R.isVideoTexture&&h.delete(R),R.isHTMLTexture&&u.delete(R)}function P(R){R.removeEventListener("dispose",N),T(R),j(R)}function B(){for(let R of p){let b=R.deref();b!==void 0&&(b.isRenderTarget===!0?P(b):F(b))}p.clear(),u.clear()}function G(R){let b=n.get(R);if(b.__webglInit===void 0)return;let k=R.source,et=f.get(k);if(et){let Q=et[b.__cacheKey];Q.usedTimes--,Q.usedTimes===0&&H(R),Object.keys(et).length===0&&f.delete(k)}n.remove(R)}function H(R){let b=n.get(R);i.deleteTexture(b.__webglTexture);let k=R.source,et=f.get(k);delete et[b.__cacheKey],o.memory.textures--}function j(R){let b=n.get(R);b.__depthDisposeCallback&&b.__depthDisposeCallback();let k=R.depthTexture;if(k&&k.renderTarget===R&&F(k),R.isWebGLCubeRenderTarget)for(let Q=0;Q<6;Q++){if(Array.isArray(b.__webglFramebuffer[Q]))for(let ot=0;ot<b.__webglFramebuffer[Q].length;ot++)i.deleteFramebuffer(b.__webglFramebuffer[Q][ot]);else i.deleteFramebuffer(b.__webglFramebuffer[Q]);b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer[Q])}else{if(Array.isArray(b.__webglFramebuffer))for(let Q=0;Q<b.__webglFramebuffer.length;Q++)i.deleteFramebuffer(b.__webglFramebuffer[Q]);else i.deleteFramebuffer(b.__webglFramebuffer);if(b.__webglDepthbuffer&&i.deleteRenderbuffer(b.__webglDepthbuffer),b.__webglMultisampledFramebuffer&&i.deleteFramebuffer(b.__webglMultisampledFramebuffer),b.__webglColorRenderbuffer)for(let Q=0;Q<b.__webglColorRenderbuffer.length;Q++)b.__webglColorRenderbuffer[Q]&&i.deleteRenderbuffer(b.__webglColorRenderbuffer[Q]);b.__webglDepthRenderbuffer&&i.deleteRenderbuffer(b.__webglDepthRenderbuffer)}let et=R.textures;for(let Q=0,ot=et.length;Q<ot;Q++){let ut=n.get(et[Q]);ut.__webglTexture&&(i.deleteTexture(ut.__webglTexture),o.memory.textures--),n.remove(et[Q])}n.remove(R)}let W=0;function Y(){W=0}function tt(){return W}function gt(R){W=R}function wt(){let R=W;return R>=s.maxTextures&&It("WebGLTextures: Trying to use "+(R+1)+" texture units while this GPU supports only "+s.maxTextures),W+=1,R}function X(R){let b=[];return b.push(R.wrapS),b.push(R.wrapT),b.push(R.wrapR||0),b.push(R.magFilter),b.push(R.minFilter),b.push(R.anisotropy),b.push(R.internalFormat),b.push(R.format),b.push(R.type),b.push(R.generateMipmaps),b.push(R.mipmapsAutoUpdate),b.push(R.premultiplyAlpha),b.push(R.flipY),b.push(R.unpackAlignment),b.push(R.colorSpace),b.join()}function rt(R,b){let k=n.get(R);if(R.isVideoTexture&&Ue(R),R.isRenderTargetTexture===!1&&R.isExternalTexture!==!0&&R.version>0&&k.__version!==R.version){let et=R.image;if(et===null)It("WebGLRenderer: Texture marked for update but no image data found.");else if(et.complete===!1)It("WebGLRenderer: Texture marked for update but image is incomplete");else{xe(k,R,b);return}}else R.isExternalTexture&&(k.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D,k.__webglTexture,i.TEXTURE0+b)}function xt(R,b){let k=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&k.__version!==R.version){xe(k,R,b);return}else R.isExternalTexture&&(k.__webglTexture=R.sourceTexture?R.sourceTexture:null);e.bindTexture(i.TEXTURE_2D_ARRAY,k.__webglTexture,i.TEXTURE0+b)}function At(R,b){let k=n.get(R);if(R.isRenderTargetTexture===!1&&R.version>0&&k.__version!==R.version){xe(k,R,b);return}e.bindTexture(i.TEXTURE_3D,k.__webglTexture,i.TEXTURE0+b)}function pt(R,b){let k=n.get(R);if(R.version>0&&k.__version!==R.version){ie(k,R,b);return}e.bindTexture(i.TEXTURE_CUBE_MAP,k.__webglTexture,i.TEXTURE0+b)}let Dt={[Za]:i.REPEAT,[ai]:i.CLAMP_TO_EDGE,[Ja]:i.MIRRORED_REPEAT},fe={[He]:i.NEAREST,[Of]:i.NEAREST_MIPMAP_NEAREST,[Co]:i.NEAREST_MIPMAP_LINEAR,[Oe]:i.LINEAR,[bc]:i.LINEAR_MIPMAP_NEAREST,[Di]:i.LINEAR_MIPMAP_LINEAR},Rt={[kf]:i.NEVER,[lu]:i.ALWAYS,[Gf]:i.LESS,[au]:i.LEQUAL,[Vf]:i.EQUAL,[cu]:i.GEQUAL,[Hf]:i.GREATER,[Wf]:i.NOTEQUAL};function Yt(R,b){if(b.type===Gn&&t.has("OES_texture_float_linear")===!1&&(b.magFilter===Oe||b.magFilter===bc||b.magFilter===Co||b.magFilter===Di||b.minFilter===Oe||b.minFilter===bc||b.minFilter===Co||b.minFilter===Di)&&It("WebGLRenderer: Unable to use linear filtering with floating point textures. OES_texture_float_linear not supported on this device."),i.texParameteri(R,i.TEXTURE_WRAP_S,Dt[b.wrapS]),i.texParameteri(R,i.TEXTURE_WRAP_T,Dt[b.wrapT]),(R===i.TEXTURE_3D||R===i.TEXTURE_2D_ARRAY)&&i.texParameteri(R,i.TEXTURE_WRAP_R,Dt[b.wrapR]),i.texParameteri(R,i.TEXTURE_MAG_FILTER,fe[b.magFilter]),i.texParameteri(R,i.TEXTURE_MIN_FILTER,fe[b.minFilter]),b.compareFunction&&(i.texParameteri(R,i.TEXTURE_COMPARE_MODE,i.COMPARE_REF_TO_TEXTURE),i.texParameteri(R,i.TEXTURE_COMPARE_FUNC,Rt[b.compareFunction])),t.has("EXT_texture_filter_anisotropic")===!0){if(b.magFilter===He||b.minFilter!==Co&&b.minFilter!==Di||b.type===Gn&&t.has("OES_texture_float_linear")===!1)return;if(b.anisotropy>1||n.get(b).__currentAnisotropy){let k=t.get("EXT_texture_filter_anisotropic");i.texParameterf(R,k.TEXTURE_MAX_ANISOTROPY_EXT,Math.min(b.anisotropy,s.getMaxAnisotropy())),n.get(b).__currentAnisotropy=b.anisotropy}}}function jt(R,b){let k=!1;R.__webglInit===void 0&&(R.__webglInit=!0,b.addEventListener("dispose",L),C(b));let et=b.source,Q=f.get(et);Q===void 0&&(Q={},f.set(et,Q));let ot=X(b);if(ot!==R.__cacheKey){Q[ot]===void 0&&(Q[ot]={texture:i.createTexture(),usedTimes:0},o.memory.textures++,k=!0),Q[ot].usedTimes++;let ut=Q[R.__cacheKey];ut!==void 0&&(Q[R.__cacheKey].usedTimes--,ut.usedTimes===0&&H(b)),R.__cacheKey=ot,R.__webglTexture=Q[ot].texture}return k}function kt(R,b,k){return Math.floor(Math.floor(R/k)/b)}function we(R,b,k,et){let ot=R.updateRanges;if(ot.length===0)e.texSubImage2D(i.TEXTURE_2D,0,0,0,b.width,b.height,k,et,b.data);else{ot.sort((D,K)=>D.start-K.start);let ut=0;for(let D=1;D<ot.length;D++){let K=ot[ut],$=ot[D],lt=K.start+K.count,it=kt($.start,b.width,4),at=kt(K.start,b.width,4);$.start<=lt+1&&it===at&&kt($.start+$.count-1,b.width,4)===it?K.count=Math.max(K.count,$.start+$.count-K.start):(++ut,ot[ut]=$)}ot.length=ut+1;let Z=e.getParameter(i.UNPACK_ROW_LENGTH),J=e.getParameter(i.UNPACK_SKIP_PIXELS),ct=e.getParameter(i.UNPACK_SKIP_ROWS);e.pixelStorei(i.UNPACK_ROW_LENGTH,b.width);for(let D=0,K=ot.length;D<K;D++){let $=ot[D],lt=Math.floor($.start/4),it=Math.ceil($.count/4),at=lt%b.width,Ct=Math.floor(lt/b.width),qt=it,nt=1;e.pixelStorei(i.UNPACK_SKIP_PIXELS,at),e.pixelStorei(i.UNPACK_SKIP_ROWS,Ct),e.texSubImage2D(i.TEXTURE_2D,0,at,Ct,qt,nt,k,et,b.data)}R.clearUpdateRanges(),e.pixelStorei(i.UNPACK_ROW_LENGTH,Z),e.pixelStorei(i.UNPACK_SKIP_PIXELS,J),e.pixelStorei(i.UNPACK_SKIP_ROWS,ct)}}function xe(R,b,k){let et=i.TEXTURE_2D;(b.isDataArrayTexture||b.isCompressedArrayTexture)&&(et=i.TEXTURE_2D_ARRAY),b.isData3DTexture&&(et=i.TEXTURE_3D);let Q=jt(R,b),ot=b.source;e.bindTexture(et,R.__webglTexture,i.TEXTURE0+k);let ut=n.get(ot);if(ot.version!==ut.__version||Q===!0){if(e.activeTexture(i.TEXTURE0+k),(typeof ImageBitmap<"u"&&b.image instanceof ImageBitmap)===!1){let nt=Kt.getPrimaries(Kt.workingColorSpace),Pt=b.colorSpace===Oi?null:Kt.getPrimaries(b.colorSpace),Ht=b.colorSpace===Oi||nt===Pt?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,Ht)}e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment);let J=y(b.image,!1,s.maxTextureSize);J=Lt(b,J);let ct=r.convert(b.format,b.colorSpace),D=r.convert(b.type),K=w(b.internalFormat,ct,D,b.normalized,b.colorSpace,b.isVideoTexture);Yt(et,b);let $,lt=b.mipmaps,it=b.isVideoTexture!==!0,at=ut.__version===void 0||Q===!0,Ct=ot.dataReady,qt=M(b,J);if(b.isDepthTexture)K=_(b.format===Ui,b.type),at&&(it?e.texStorage2D(i.TEXTURE_2D,1,K,J.width,J.height):e.texImage2D(i.TEXTURE_2D,0,K,J.width,J.height,0,ct,D,null));else if(b.isDataTexture)if(lt.length>0){it&&at&&e.texStorage2D(i.TEXTURE_2D,qt,K,lt[0].width,lt[0].height);for(let nt=0,Pt=lt.length;nt<Pt;nt++)$=lt[nt],it?Ct&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,$.width,$.height,ct,D,$.data):e.texImage2D(i.TEXTURE_2D,nt,K,$.width,$.height,0,ct,D,$.data);b.generateMipmaps=!1}else it?(at&&e.texStorage2D(i.TEXTURE_2D,qt,K,J.width,J.height),Ct&&we(b,J,ct,D)):e.texImage2D(i.TEXTURE_2D,0,K,J.width,J.height,0,ct,D,J.data);else if(b.isCompressedTexture)if(b.isCompressedArrayTexture){it&&at&&e.texStorage3D(i.TEXTURE_2D_ARRAY,qt,K,lt[0].width,lt[0].height,J.depth);for(let nt=0,Pt=lt.length;nt<Pt;nt++)if($=lt[nt],b.format!==ti)if(ct!==null)if(it){if(Ct)if(b.layerUpdates.size>0){let Ht=yu($.width,$.height,b.format,b.type);for(let _t of b.layerUpdates){let le=$.data.subarray(_t*Ht/$.data.BYTES_PER_ELEMENT,(_t+1)*Ht/$.data.BYTES_PER_ELEMENT);e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,_t,$.width,$.height,1,ct,le)}}else e.compressedTexSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,$.width,$.height,J.depth,ct,$.data)}else e.compressedTexImage3D(i.TEXTURE_2D_ARRAY,nt,K,$.width,$.height,J.depth,0,$.data,0,0);else It("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()");else it?Ct&&e.texSubImage3D(i.TEXTURE_2D_ARRAY,nt,0,0,0,$.width,$.height,J.depth,ct,D,$.data):e.texImage3D(i.TEXTURE_2D_ARRAY,nt,K,$.width,$.height,J.depth,0,ct,D,$.data);b.layerUpdates.size>0&&b.clearLayerUpdates()}else{it&&at&&e.texStorage2D(i.TEXTURE_2D,qt,K,lt[0].width,lt[0].height);for(let nt=0,Pt=lt.length;nt<Pt;nt++)$=lt[nt],b.format!==ti?ct!==null?it?Ct&&e.compressedTexSubImage2D(i.TEXTURE_2D,nt,0,0,$.width,$.height,ct,$.data):e.compressedTexImage2D(i.TEXTURE_2D,nt,K,$.width,$.height,0,$.data):It("WebGLRenderer: Attempt to load unsupported compressed texture format in .uploadTexture()"):it?Ct&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,$.width,$.height,ct,D,$.data):e.texImage2D(i.TEXTURE_2D,nt,K,$.width,$.height,0,ct,D,$.data)}else if(b.isDataArrayTexture)if(it){if(at&&e.texStorage3D(i.TEXTURE_2D_ARRAY,qt,K,J.width,J.height,J.depth),Ct)if(b.layerUpdates.size>0){let nt=yu(J.width,J.height,b.format,b.type);for(let Pt of b.layerUpdates){let Ht=J.data.subarray(Pt*nt/J.data.BYTES_PER_ELEMENT,(Pt+1)*nt/J.data.BYTES_PER_ELEMENT);e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,Pt,J.width,J.height,1,ct,D,Ht)}b.clearLayerUpdates()}else e.texSubImage3D(i.TEXTURE_2D_ARRAY,0,0,0,0,J.width,J.height,J.depth,ct,D,J.data)}else e.texImage3D(i.TEXTURE_2D_ARRAY,0,K,J.width,J.height,J.depth,0,ct,D,J.data);else if(b.isData3DTexture)it?(at&&e.texStorage3D(i.TEXTURE_3D,qt,K,J.width,J.height,J.depth),Ct&&e.texSubImage3D(i.TEXTURE_3D,0,0,0,0,J.width,J.height,J.depth,ct,D,J.data)):e.texImage3D(i.TEXTURE_3D,0,K,J.width,J.height,J.depth,0,ct,D,J.data);else if(b.isFramebufferTexture){if(at)if(it)e.texStorage2D(i.TEXTURE_2D,qt,K,J.width,J.height);else{let nt=J.width,Pt=J.height;for(let Ht=0;Ht<qt;Ht++)e.texImage2D(i.TEXTURE_2D,Ht,K,nt,Pt,0,ct,D,null),nt>>=1,Pt>>=1}}else if(b.isHTMLTexture){if("texElementImage2D"in i){let nt=i.canvas;if(nt.hasAttribute("layoutsubtree")||nt.setAttribute("layoutsubtree","true"),J.parentNode!==nt){nt.appendChild(J),u.add(b),nt.onpaint=Pt=>{let Ht=Pt.changedElements;for(let _t of u)Ht.includes(_t.image)&&(_t.needsUpdate=!0)},nt.requestPaint();return}if(i.texElementImage2D.length===3)i.texElementImage2D(i.TEXTURE_2D,i.RGBA8,J);else{let Ht=i.RGBA,_t=i.RGBA,le=i.UNSIGNED_BYTE;i.texElementImage2D(i.TEXTURE_2D,0,Ht,_t,le,J)}i.texParameteri(i.TEXTURE_2D,i.TEXTURE_MIN_FILTER,i.LINEAR),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_S,i.CLAMP_TO_EDGE),i.texParameteri(i.TEXTURE_2D,i.TEXTURE_WRAP_T,i.CLAMP_TO_EDGE)}}else if(lt.length>0){if(it&&at){let nt=Ft(lt[0]);e.texStorage2D(i.TEXTURE_2D,qt,K,nt.width,nt.height)}for(let nt=0,Pt=lt.length;nt<Pt;nt++)$=lt[nt],it?Ct&&e.texSubImage2D(i.TEXTURE_2D,nt,0,0,ct,D,$):e.texImage2D(i.TEXTURE_2D,nt,K,ct,D,$);b.generateMipmaps=!1}else if(it){if(at){let nt=Ft(J);e.texStorage2D(i.TEXTURE_2D,qt,K,nt.width,nt.height)}Ct&&e.texSubImage2D(i.TEXTURE_2D,0,0,0,ct,D,J)}else e.texImage2D(i.TEXTURE_2D,0,K,ct,D,J);S(b)&&b.mipmapsAutoUpdate===!0&&v(et),ut.__version=ot.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}function ie(R,b,k){if(b.image.length!==6)return;let et=jt(R,b),Q=b.source;e.bindTexture(i.TEXTURE_CUBE_MAP,R.__webglTexture,i.TEXTURE0+k);let ot=n.get(Q);if(Q.version!==ot.__version||et===!0){e.activeTexture(i.TEXTURE0+k);let ut=Kt.getPrimaries(Kt.workingColorSpace),Z=b.colorSpace===Oi?null:Kt.getPrimaries(b.colorSpace),J=b.colorSpace===Oi||ut===Z?i.NONE:i.BROWSER_DEFAULT_WEBGL;e.pixelStorei(i.UNPACK_FLIP_Y_WEBGL,b.flipY),e.pixelStorei(i.UNPACK_PREMULTIPLY_ALPHA_WEBGL,b.premultiplyAlpha),e.pixelStorei(i.UNPACK_ALIGNMENT,b.unpackAlignment),e.pixelStorei(i.UNPACK_COLORSPACE_CONVERSION_WEBGL,J);let ct=b.isCompressedTexture||b.image[0].isCompressedTexture,D=b.image[0]&&b.image[0].isDataTexture,K=[];for(let _t=0;_t<6;_t++)!ct&&!D?K[_t]=y(b.image[_t],!0,s.maxCubemapSize):K[_t]=D?b.image[_t].image:b.image[_t],K[_t]=Lt(b,K[_t]);let $=K[0],lt=r.convert(b.format,b.colorSpace),it=r.convert(b.type),at=w(b.internalFormat,lt,it,b.normalized,b.colorSpace),Ct=b.isVideoTexture!==!0,qt=ot.__version===void 0||et===!0,nt=Q.dataReady,Pt=M(b,$);Yt(i.TEXTURE_CUBE_MAP,b);let Ht;if(b.isDepthTexture){if(at=_(b.format===Ui,b.type),qt)if(Ct)e.texStorage2D(i.TEXTURE_CUBE_MAP,1,at,$.width,$.height);else for(let _t=0;_t<6;_t++)e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,at,$.width,$.height,0,lt,it,null)}else if(ct){Ct&&qt&&e.texStorage2D(i.TEXTURE_CUBE_MAP,Pt,at,$.width,$.height);for(let _t=0;_t<6;_t++){Ht=K[_t].mipmaps;for(let le=0;le<Ht.length;le++){let ke=Ht[le];b.format!==ti?lt!==null?Ct?nt&&e.compressedTexSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le,0,0,ke.width,ke.height,lt,ke.data):e.compressedTexImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le,at,ke.width,ke.height,0,ke.data):It("WebGLRenderer: Attempt to load unsupported compressed texture format in .setTextureCube()"):Ct?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le,0,0,ke.width,ke.height,lt,it,ke.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le,at,ke.width,ke.height,0,lt,it,ke.data)}}}else{if(Ht=b.mipmaps,Ct&&qt){Ht.length>0&&Pt++;let _t=Ft(K[0]);e.texStorage2D(i.TEXTURE_CUBE_MAP,Pt,at,_t.width,_t.height)}for(let _t=0;_t<6;_t++)if(D){Ct?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,0,0,K[_t].width,K[_t].height,lt,it,K[_t].data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,at,K[_t].width,K[_t].height,0,lt,it,K[_t].data);for(let le=0;le<Ht.length;le++){let Hi=Ht[le].image[_t].image;Ct?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le+1,0,0,Hi.width,Hi.height,lt,it,Hi.data):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le+1,at,Hi.width,Hi.height,0,lt,it,Hi.data)}}else{Ct?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,0,0,lt,it,K[_t]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,0,at,lt,it,K[_t]);for(let le=0;le<Ht.length;le++){let ke=Ht[le];Ct?nt&&e.texSubImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le+1,0,0,lt,it,ke.image[_t]):e.texImage2D(i.TEXTURE_CUBE_MAP_POSITIVE_X+_t,le+1,at,lt,it,ke.image[_t])}}}S(b)&&b.mipmapsAutoUpdate===!0&&v(i.TEXTURE_CUBE_MAP),ot.__version=Q.version,b.onUpdate&&b.onUpdate(b)}R.__version=b.version}function pe(R,b,k,et,Q,ot){let ut=r.convert(k.format,k.colorSpace),Z=r.convert(k.type),J=w(k.internalFormat,ut,Z,k.normalized,k.colorSpace),ct=n.get(b),D=n.get(k);if(D.__renderTarget=b,!ct.__hasExternalTextures){let K=Math.max(1,b.width>>ot),$=Math.max(1,b.height>>ot);Q===i.TEXTURE_3D||Q===i.TEXTURE_2D_ARRAY?e.texImage3D(Q,ot,J,K,$,b.depth,0,ut,Z,null):e.texImage2D(Q,ot,J,K,$,0,ut,Z,null)}e.bindFramebuffer(i.FRAMEBUFFER,R),mt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,et,Q,D.__webglTexture,0,Me(b)):(Q===i.TEXTURE_2D||Q>=i.TEXTURE_CUBE_MAP_POSITIVE_X&&Q<=i.TEXTURE_CUBE_MAP_NEGATIVE_Z)&&i.framebufferTexture2D(i.FRAMEBUFFER,et,Q,D.__webglTexture,ot),e.bindFramebuffer(i.FRAMEBUFFER,null)}function Mn(R,b,k){if(i.bindRenderbuffer(i.RENDERBUFFER,R),b.depthBuffer){let et=b.depthTexture,Q=et&&et.isDepthTexture?et.type:null,ot=_(b.stencilBuffer,Q),ut=b.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;mt(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Me(b),ot,b.width,b.height):k?i.renderbufferStorageMultisample(i.RENDERBUFFER,Me(b),ot,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,ot,b.width,b.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,ut,i.RENDERBUFFER,R)}else{let et=b.textures;for(let Q=0;Q<et.length;Q++){let ot=et[Q],ut=r.convert(ot.format,ot.colorSpace),Z=r.convert(ot.type),J=w(ot.internalFormat,ut,Z,ot.normalized,ot.colorSpace);mt(b)?a.renderbufferStorageMultisampleEXT(i.RENDERBUFFER,Me(b),J,b.width,b.height):k?i.renderbufferStorageMultisample(i.RENDERBUFFER,Me(b),J,b.width,b.height):i.renderbufferStorage(i.RENDERBUFFER,J,b.width,b.height)}}i.bindRenderbuffer(i.RENDERBUFFER,null)}function Ce(R,b,k){let et=b.isWebGLCubeRenderTarget===!0;if(e.bindFramebuffer(i.FRAMEBUFFER,R),!(b.depthTexture&&b.depthTexture.isDepthTexture))throw new Error("THREE.WebGLTextures: renderTarget.depthTexture must be an instance of THREE.DepthTexture.");let Q=n.get(b.depthTexture);Q.__renderTarget=b;let ot=et?b.depthTexture.image[0]:b.depthTexture.image;(!Q.__webglTexture||ot.width!==b.width||ot.height!==b.height)&&(ot.width=b.width,ot.height=b.height,b.depthTexture.needsUpdate=!0),et?pt(b.depthTexture,0):rt(b.depthTexture,0);let ut=Q.__webglTexture,Z=Me(b),J=et?i.TEXTURE_CUBE_MAP_POSITIVE_X+k:i.TEXTURE_2D,ct=b.depthTexture.format===Ui?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;if(b.depthTexture.format===Ci)mt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ct,J,ut,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,ct,J,ut,0);else if(b.depthTexture.format===Ui)mt(b)?a.framebufferTexture2DMultisampleEXT(i.FRAMEBUFFER,ct,J,ut,0,Z):i.framebufferTexture2D(i.FRAMEBUFFER,ct,J,ut,0);else throw new Error("THREE.WebGLTextures: Unknown depthTexture format.")}function rn(R){let b=n.get(R),k=R.isWebGLCubeRenderTarget===!0;if(b.__boundDepthTexture!==R.depthTexture){let et=R.depthTexture;if(b.__depthDisposeCallback&&b.__depthDisposeCallback(),et){let Q=()=>{delete b.__boundDepthTexture,delete b.__depthDisposeCallback,et.removeEventListener("dispose",Q)};et.addEventListener("dispose",Q),b.__depthDisposeCallback=Q}b.__boundDepthTexture=et}if(R.depthTexture&&!b.__autoAllocateDepthBuffer)if(k)for(let et=0;et<6;et++)Ce(b.__webglFramebuffer[et],R,et);else R.texture.mipmaps.length>0?Ce(b.__webglFramebuffer[0],R,0):Ce(b.__webglFramebuffer,R,0);else if(k){b.__webglDepthbuffer=[];for(let et=0;et<6;et++)if(e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[et]),b.__webglDepthbuffer[et]===void 0)b.__webglDepthbuffer[et]=i.createRenderbuffer(),Mn(b.__webglDepthbuffer[et],R,!1);else{let Q=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ot=b.__webglDepthbuffer[et];i.bindRenderbuffer(i.RENDERBUFFER,ot),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,ot)}}else if(R.texture.mipmaps.length>0?e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer[0]):e.bindFramebuffer(i.FRAMEBUFFER,b.__webglFramebuffer),b.__webglDepthbuffer===void 0)b.__webglDepthbuffer=i.createRenderbuffer(),Mn(b.__webglDepthbuffer,R,!1);else{let Q=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ot=b.__webglDepthbuffer;i.bindRenderbuffer(i.RENDERBUFFER,ot),i.framebufferRenderbuffer(i.FRAMEBUFFER,Q,i.RENDERBUFFER,ot)}e.bindFramebuffer(i.FRAMEBUFFER,null)}function Dn(R,b,k){let et=n.get(R);b!==void 0&&pe(et.__webglFramebuffer,R,R.texture,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,0),k!==void 0&&rn(R)}function Un(R){let b=R.texture,k=n.get(R),et=n.get(b);R.addEventListener("dispose",N),C(R);let Q=R.textures,ot=R.isWebGLCubeRenderTarget===!0,ut=Q.length>1;if(ut||(et.__webglTexture===void 0&&(et.__webglTexture=i.createTexture()),et.__version=b.version,o.memory.textures++),ot){k.__webglFramebuffer=[];for(let Z=0;Z<6;Z++)if(b.mipmaps.length>0){k.__webglFramebuffer[Z]=[];for(let J=0;J<b.mipmaps.length;J++)k.__webglFramebuffer[Z][J]=i.createFramebuffer()}else k.__webglFramebuffer[Z]=i.createFramebuffer()}else{if(b.mipmaps.length>0){k.__webglFramebuffer=[];for(let Z=0;Z<b.mipmaps.length;Z++)k.__webglFramebuffer[Z]=i.createFramebuffer()}else k.__webglFramebuffer=i.createFramebuffer();if(ut)for(let Z=0,J=Q.length;Z<J;Z++){let ct=n.get(Q[Z]);ct.__webglTexture===void 0&&(ct.__webglTexture=i.createTexture(),o.memory.textures++)}if(R.samples>0&&mt(R)===!1){k.__webglMultisampledFramebuffer=i.createFramebuffer(),k.__webglColorRenderbuffer=[],e.bindFramebuffer(i.FRAMEBUFFER,k.__webglMultisampledFramebuffer);for(let Z=0;Z<Q.length;Z++){let J=Q[Z];k.__webglColorRenderbuffer[Z]=i.createRenderbuffer(),i.bindRenderbuffer(i.RENDERBUFFER,k.__webglColorRenderbuffer[Z]);let ct=r.convert(J.format,J.colorSpace),D=r.convert(J.type),K=w(J.internalFormat,ct,D,J.normalized,J.colorSpace,R.isXRRenderTarget===!0),$=Me(R);i.renderbufferStorageMultisample(i.RENDERBUFFER,$,K,R.width,R.height),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+Z,i.RENDERBUFFER,k.__webglColorRenderbuffer[Z])}i.bindRenderbuffer(i.RENDERBUFFER,null),R.depthBuffer&&(k.__webglDepthRenderbuffer=i.createRenderbuffer(),Mn(k.__webglDepthRenderbuffer,R,!0)),e.bindFramebuffer(i.FRAMEBUFFER,null)}}if(ot){e.bindTexture(i.TEXTURE_CUBE_MAP,et.__webglTexture),Yt(i.TEXTURE_CUBE_MAP,b);for(let Z=0;Z<6;Z++)if(b.mipmaps.length>0)for(let J=0;J<b.mipmaps.length;J++)pe(k.__webglFramebuffer[Z][J],R,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,J);else pe(k.__webglFramebuffer[Z],R,b,i.COLOR_ATTACHMENT0,i.TEXTURE_CUBE_MAP_POSITIVE_X+Z,0);S(b)?v(i.TEXTURE_CUBE_MAP):b.mipmaps.length>0&&i.texParameteri(i.TEXTURE_CUBE_MAP,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}else if(ut){for(let Z=0,J=Q.length;Z<J;Z++){let ct=Q[Z],D=n.get(ct),K=i.TEXTURE_2D;(R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(K=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(K,D.__webglTexture),Yt(K,ct),pe(k.__webglFramebuffer,R,ct,i.COLOR_ATTACHMENT0+Z,K,0),S(ct)&&v(K)}e.unbindTexture()}else{let Z=i.TEXTURE_2D;if((R.isWebGL3DRenderTarget||R.isWebGLArrayRenderTarget)&&(Z=R.isWebGL3DRenderTarget?i.TEXTURE_3D:i.TEXTURE_2D_ARRAY),e.bindTexture(Z,et.__webglTexture),Yt(Z,b),b.mipmaps.length>0)for(let J=0;J<b.mipmaps.length;J++)pe(k.__webglFramebuffer[J],R,b,i.COLOR_ATTACHMENT0,Z,J);else pe(k.__webglFramebuffer,R,b,i.COLOR_ATTACHMENT0,Z,0);S(b)?v(Z):b.mipmaps.length>0&&i.texParameteri(Z,i.TEXTURE_MAX_LEVEL,b.mipmaps.length-1),e.unbindTexture()}R.depthBuffer&&rn(R)}function O(R){let b=R.textures;for(let k=0,et=b.length;k<et;k++){let Q=b[k];if(S(Q)&&Q.mipmapsAutoUpdate===!0){let ot=A(R),ut=n.get(Q).__webglTexture;e.bindTexture(ot,ut),v(ot),e.unbindTexture()}}}let On=[];function ve(R){if(R.samples>0){if(mt(R)===!1){let b=R.textures,k=R.width,et=R.height,Q=i.COLOR_BUFFER_BIT,ot=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT,ut=n.get(R),Z=b.length>1;if(Z)for(let ct=0;ct<b.length;ct++)e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.RENDERBUFFER,null),e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.TEXTURE_2D,null,0);e.bindFramebuffer(i.READ_FRAMEBUFFER,ut.__webglMultisampledFramebuffer),R.texture.mipmaps.length>0?e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ut.__webglFramebuffer[0]):e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ut.__webglFramebuffer);for(let ct=0;ct<b.length;ct++){if(R.resolveDepthBuffer&&(R.depthBuffer&&(Q|=i.DEPTH_BUFFER_BIT),R.stencilBuffer&&R.resolveStencilBuffer&&(Q|=i.STENCIL_BUFFER_BIT)),Z){i.framebufferRenderbuffer(i.READ_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.RENDERBUFFER,ut.__webglColorRenderbuffer[ct]);let D=n.get(b[ct]).__webglTexture;i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0,i.TEXTURE_2D,D,0)}i.blitFramebuffer(0,0,k,et,0,0,k,et,Q,i.NEAREST),c===!0&&(On.length=0,On.push(i.COLOR_ATTACHMENT0+ct),R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&On.push(ot),i.invalidateFramebuffer(i.READ_FRAMEBUFFER,On))}if(e.bindFramebuffer(i.READ_FRAMEBUFFER,null),e.bindFramebuffer(i.DRAW_FRAMEBUFFER,null),Z)for(let ct=0;ct<b.length;ct++){e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglMultisampledFramebuffer),i.framebufferRenderbuffer(i.FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.RENDERBUFFER,ut.__webglColorRenderbuffer[ct]);let D=n.get(b[ct]).__webglTexture;e.bindFramebuffer(i.FRAMEBUFFER,ut.__webglFramebuffer),i.framebufferTexture2D(i.DRAW_FRAMEBUFFER,i.COLOR_ATTACHMENT0+ct,i.TEXTURE_2D,D,0)}e.bindFramebuffer(i.DRAW_FRAMEBUFFER,ut.__webglMultisampledFramebuffer)}else if(R.depthBuffer&&R.storeMultisampledDepthBuffer===!1&&c){let b=R.stencilBuffer?i.DEPTH_STENCIL_ATTACHMENT:i.DEPTH_ATTACHMENT;i.invalidateFramebuffer(i.DRAW_FRAMEBUFFER,[b])}}}function Me(R){return Math.min(s.maxSamples,R.samples)}function mt(R){let b=n.get(R);return R.samples>0&&t.has("WEBGL_multisampled_render_to_texture")===!0&&b.__useRenderToTexture!==!1}function Ue(R){let b=o.render.frame;h.get(R)!==b&&(h.set(R,b),R.update())}function Lt(R,b){let k=R.colorSpace,et=R.format,Q=R.type;return R.isCompressedTexture===!0||R.isVideoTexture===!0||k!==no&&k!==Oi&&(Kt.getTransfer(k)===oe?(et!==ti||Q!==_n)&&It("WebGLTextures: sRGB encoded textures have to use RGBAFormat and UnsignedByteType."):Ut("WebGLTextures: Unsupported texture color space:",k)),b}function Ft(R){return typeof HTMLImageElement<"u"&&R instanceof HTMLImageElement?(l.width=R.naturalWidth||R.width,l.height=R.naturalHeight||R.height):typeof VideoFrame<"u"&&R instanceof VideoFrame?(l.width=R.displayWidth,l.height=R.displayHeight):(l.width=R.width,l.height=R.height),l}this.allocateTextureUnit=wt,this.resetTextureUnits=Y,this.getTextureUnits=tt,this.setTextureUnits=gt,this.setTexture2D=rt,this.setTexture2DArray=xt,this.setTexture3D=At,this.setTextureCube=pt,this.rebindTextures=Dn,this.setupRenderTarget=Un,this.updateRenderTargetMipmap=O,this.updateMultisampleRenderTarget=ve,this.setupDepthRenderbuffer=rn,this.setupFrameBufferTexture=pe,this.useMultisampledRTT=mt,this.dispose=B}function CM(i,t){function e(n,s=Oi){let r,o=Kt.getTransfer(s);if(n===_n)return i.UNSIGNED_BYTE;if(n===Ac)return i.UNSIGNED_SHORT_4_4_4_4;if(n===Ec)return i.UNSIGNED_SHORT_5_5_5_1;if(n===iu)return i.UNSIGNED_INT_5_9_9_9_REV;if(n===su)return i.UNSIGNED_INT_10F_11F_11F_REV;if(n===eu)return i.BYTE;if(n===nu)return i.SHORT;if(n===Mr)return i.UNSIGNED_SHORT;if(n===wc)return i.INT;if(n===jn)return i.UNSIGNED_INT;if(n===Gn)return i.FLOAT;if(n===Qn)return i.HALF_FLOAT;if(n===ru)return i.ALPHA;if(n===ou)return i.RGB;if(n===ti)return i.RGBA;if(n===Ci)return i.DEPTH_COMPONENT;if(n===Ui)return i.DEPTH_STENCIL;if(n===Tc)return i.RED;if(n===Rc)return i.RED_INTEGER;if(n===rs)return i.RG;if(n===Cc)return i.RG_INTEGER;if(n===Pc)return i.RGBA_INTEGER;if(n===Po||n===Io||n===Lo||n===No)if(o===oe)if(r=t.get("WEBGL_compressed_texture_s3tc_srgb"),r!==null){if(n===Po)return r.COMPRESSED_SRGB_S3TC_DXT1_EXT;if(n===Io)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT1_EXT;if(n===Lo)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT3_EXT;if(n===No)return r.COMPRESSED_SRGB_ALPHA_S3TC_DXT5_EXT}else return null;else if(r=t.get("WEBGL_compressed_texture_s3tc"),r!==null){if(n===Po)return r.COMPRESSED_RGB_S3TC_DXT1_EXT;if(n===Io)return r.COMPRESSED_RGBA_S3TC_DXT1_EXT;if(n===Lo)return r.COMPRESSED_RGBA_S3TC_DXT3_EXT;if(n===No)return r.COMPRESSED_RGBA_S3TC_DXT5_EXT}else return null;if(n===Ic||n===Lc||n===Nc||n===Dc)if(r=t.get("WEBGL_compressed_texture_pvrtc"),r!==null){if(n===Ic)return r.COMPRESSED_RGB_PVRTC_4BPPV1_IMG;if(n===Lc)return r.COMPRESSED_RGB_PVRTC_2BPPV1_IMG;if(n===Nc)return r.COMPRESSED_RGBA_PVRTC_4BPPV1_IMG;if(n===Dc)return r.COMPRESSED_RGBA_PVRTC_2BPPV1_IMG}else return null;if(n===Uc||n===Oc||n===Fc||n===Bc||n===zc||n===Do||n===kc)if(r=t.get("WEBGL_compressed_texture_etc"),r!==null){if(n===Uc||n===Oc)return o===oe?r.COMPRESSED_SRGB8_ETC2:r.COMPRESSED_RGB8_ETC2;if(n===Fc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ETC2_EAC:r.COMPRESSED_RGBA8_ETC2_EAC;if(n===Bc)return r.COMPRESSED_R11_EAC;if(n===zc)return r.COMPRESSED_SIGNED_R11_EAC;if(n===Do)return r.COMPRESSED_RG11_EAC;if(n===kc)return r.COMPRESSED_SIGNED_RG11_EAC}else return null;if(n===Gc||n===Vc||n===Hc||n===Wc||n===qc||n===Xc||n===$c||n===Yc||n===Zc||n===Jc||n===Kc||n===jc||n===Qc||n===tl)if(r=t.get("WEBGL_compressed_texture_astc"),r!==null){if(n===Gc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_4x4_KHR:r.COMPRESSED_RGBA_ASTC_4x4_KHR;if(n===Vc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x4_KHR:r.COMPRESSED_RGBA_ASTC_5x4_KHR;if(n===Hc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_5x5_KHR:r.COMPRESSED_RGBA_ASTC_5x5_KHR;if(n===Wc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x5_KHR:r.COMPRESSED_RGBA_ASTC_6x5_KHR;if(n===qc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_6x6_KHR:r.COMPRESSED_RGBA_ASTC_6x6_KHR;if(n===Xc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x5_KHR:r.COMPRESSED_RGBA_ASTC_8x5_KHR;if(n===$c)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x6_KHR:r.COMPRESSED_RGBA_ASTC_8x6_KHR;if(n===Yc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_8x8_KHR:r.COMPRESSED_RGBA_ASTC_8x8_KHR;if(n===Zc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x5_KHR:r.COMPRESSED_RGBA_ASTC_10x5_KHR;if(n===Jc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x6_KHR:r.COMPRESSED_RGBA_ASTC_10x6_KHR;if(n===Kc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x8_KHR:r.COMPRESSED_RGBA_ASTC_10x8_KHR;if(n===jc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_10x10_KHR:r.COMPRESSED_RGBA_ASTC_10x10_KHR;if(n===Qc)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x10_KHR:r.COMPRESSED_RGBA_ASTC_12x10_KHR;if(n===tl)return o===oe?r.COMPRESSED_SRGB8_ALPHA8_ASTC_12x12_KHR:r.COMPRESSED_RGBA_ASTC_12x12_KHR}else return null;if(n===el||n===nl||n===il)if(r=t.get("EXT_texture_compression_bptc"),r!==null){if(n===el)return o===oe?r.COMPRESSED_SRGB_ALPHA_BPTC_UNORM_EXT:r.COMPRESSED_RGBA_BPTC_UNORM_EXT;if(n===nl)return r.COMPRESSED_RGB_BPTC_SIGNED_FLOAT_EXT;if(n===il)return r.COMPRESSED_RGB_BPTC_UNSIGNED_FLOAT_EXT}else return null;if(n===sl||n===rl||n===Uo||n===ol)if(r=t.get("EXT_texture_compression_rgtc"),r!==null){if(n===sl)return r.COMPRESSED_RED_RGTC1_EXT;if(n===rl)return r.COMPRESSED_SIGNED_RED_RGTC1_EXT;if(n===Uo)return r.COMPRESSED_RED_GREEN_RGTC2_EXT;if(n===ol)return r.COMPRESSED_SIGNED_RED_GREEN_RGTC2_EXT}else return null;return n===Os?i.UNSIGNED_INT_24_8:i[n]!==void 0?i[n]:null}return{convert:e}}var PM=`
void main() {

	gl_Position = vec4( position, 1.0 );

}`,IM=`
uniform sampler2DArray depthColor;
uniform float depthWidth;
uniform float depthHeight;

void main() {

	vec2 coord = vec2( gl_FragCoord.x / depthWidth, gl_FragCoord.y / depthHeight );

	if ( coord.x >= 1.0 ) {

		gl_FragDepth = texture( depthColor, vec3( coord.x - 1.0, coord.y, 1 ) ).r;

	} else {

		gl_FragDepth = texture( depthColor, vec3( coord.x, coord.y, 0 ) ).r;

	}

}`,Ru=class{constructor(){this.texture=null,this.mesh=null,this.depthNear=0,this.depthFar=0}init(t,e){if(this.texture===null){let n=new xo(t.texture);(t.depthNear!==e.depthNear||t.depthFar!==e.depthFar)&&(this.depthNear=t.depthNear,this.depthFar=t.depthFar),this.texture=n}}getMesh(t){if(this.texture!==null&&this.mesh===null){let e=t.cameras[0].viewport,n=new kn({vertexShader:PM,fragmentShader:IM,uniforms:{depthColor:{value:this.texture},depthWidth:{value:e.z},depthHeight:{value:e.w}}});this.mesh=new ee(new Ls(20,20),n)}return this.mesh}reset(){this.texture=null,this.mesh=null}getDepthTexture(){return this.texture}},Cu=class extends ci{constructor(t,e){super();let n=this,s=null,r=1,o=null,a="local-floor",c=1,l=null,h=null,u=null,d=null,f=null,p=null,x=typeof XRWebGLBinding<"u",m=new Ru,g={},y=e.getContextAttributes(),S=null,v=null,A=[],w=[],_=new Wt,M=null,C=null,T=new cn;T.viewport=new ce;let L=new cn;L.viewport=new ce;let N=[T,L],F=new yc,P=null,B=null;this.cameraAutoUpdate=!0,this.enabled=!1,this.isPresenting=!1,this.getController=function(X){let rt=A[X];return rt===void 0&&(rt=new ur,A[X]=rt),rt.getTargetRaySpace()},this.getControllerGrip=function(X){let rt=A[X];return rt===void 0&&(rt=new ur,A[X]=rt),rt.getGripSpace()},this.getHand=function(X){let rt=A[X];return rt===void 0&&(rt=new ur,A[X]=rt),rt.getHandSpace()};function G(X){let rt=w.indexOf(X.inputSource);if(rt===-1)return;let xt=A[rt];xt!==void 0&&(xt.update(X.inputSource,X.frame,l||o),xt.dispatchEvent({type:X.type,data:X.inputSource}))}function H(){s.removeEventListener("select",G),s.removeEventListener("selectstart",G),s.removeEventListener("selectend",G),s.removeEventListener("squeeze",G),s.removeEventListener("squeezestart",G),s.removeEventListener("squeezeend",G),s.removeEventListener("end",H),s.removeEventListener("inputsourceschange",j);for(let X=0;X<A.length;X++){let rt=w[X];rt!==null&&(w[X]=null,A[X].disconnect(rt))}P=null,B=null,m.reset();for(let X in g)delete g[X];if(t.setRenderTarget(S),f=null,d=null,u=null,s=null,v=null,wt.stop(),n.isPresenting=!1,t.setPixelRatio(M),t.setSize(_.width,_.height,!1),C!==null){let X=C.camera;X.fov=C.fov,X.zoom=C.zoom,X.updateProjectionMatrix(),C=null}n.dispatchEvent({type:"sessionend"})}this.setFramebufferScaleFactor=function(X){r=X,n.isPresenting===!0&&It("WebXRManager: Cannot change framebuffer scale while presenting.")},this.setReferenceSpaceType=function(X){a=X,n.isPresenting===!0&&It("WebXRManager: Cannot change reference space type while presenting.")},this.getReferenceSpace=function(){return l||o},this.setReferenceSpace=function(X){l=X},this.getBaseLayer=function(){return d!==null?d:f},this.getBinding=function(){return u===null&&x&&(u=new XRWebGLBinding(s,e)),u},this.getFrame=function(){return p},this.getSession=function(){return s},this.setSession=async function(X){if(s=X,s!==null){if(S=t.getRenderTarget(),s.addEventListener("select",G),s.addEventListener("selectstart",G),s.addEventListener("selectend",G),s.addEventListener("squeeze",G),s.addEventListener("squeezestart",G),s.addEventListener("squeezeend",G),s.addEventListener("end",H),s.addEventListener("inputsourceschange",j),y.xrCompatible!==!0&&await e.makeXRCompatible(),M=t.getPixelRatio(),t.getSize(_),x&&"createProjectionLayer"in XRWebGLBinding.prototype){let xt=null,At=null,pt=null;y.depth&&(pt=y.stencil?e.DEPTH24_STENCIL8:e.DEPTH_COMPONENT24,xt=y.stencil?Ui:Ci,At=y.stencil?Os:jn);let Dt={colorFormat:e.RGBA8,depthFormat:pt,scaleFactor:r};u=this.getBinding(),d=u.createProjectionLayer(Dt),s.updateRenderState({layers:[d]}),t.setPixelRatio(1),t.setSize(d.textureWidth,d.textureHeight,!1),v=new An(d.textureWidth,d.textureHeight,{format:ti,type:_n,depthTexture:new Li(d.textureWidth,d.textureHeight,At,void 0,void 0,void 0,void 0,void 0,void 0,xt),stencilBuffer:y.stencil,colorSpace:t.outputColorSpace,samples:y.antialias?4:0,resolveDepthBuffer:d.ignoreDepthValues===!1,resolveStencilBuffer:d.ignoreDepthValues===!1,storeMultisampledDepthBuffer:d.ignoreDepthValues===!1,storeMultisampledStencilBuffer:d.ignoreDepthValues===!1})}else{let xt={antialias:y.antialias,alpha:!0,depth:y.depth,stencil:y.stencil,framebufferScaleFactor:r};f=new XRWebGLLayer(s,e,xt),s.updateRenderState({baseLayer:f}),t.setPixelRatio(1),t.setSize(f.framebufferWidth,f.framebufferHeight,!1),v=new An(f.framebufferWidth,f.framebufferHeight,{format:ti,type:_n,colorSpace:t.outputColorSpace,stencilBuffer:y.stencil,resolveDepthBuffer:f.ignoreDepthValues===!1,resolveStencilBuffer:f.ignoreDepthValues===!1,storeMultisampledDepthBuffer:f.ignoreDepthValues===!1,storeMultisampledStencilBuffer:f.ignoreDepthValues===!1})}v.isXRRenderTarget=!0,this.setFoveation(c),l=null,o=await s.requestReferenceSpace(a),wt.setContext(s),wt.start(),n.isPresenting=!0,n.dispatchEvent({type:"sessionstart"})}},this.getEnvironmentBlendMode=function(){if(s!==null)return s.environmentBlendMode},this.getDepthTexture=function(){return m.getDepthTexture()};function j(X){for(let rt=0;rt<X.removed.length;rt++){let xt=X.removed[rt],At=w.indexOf(xt);At>=0&&(w[At]=null,A[At].disconnect(xt))}for(let rt=0;rt<X.added.length;rt++){let xt=X.added[rt],At=w.indexOf(xt);if(At===-1){for(let Dt=0;Dt<A.length;Dt++)if(Dt>=w.length){w.push(xt),At=Dt;break}else if(w[Dt]===null){w[Dt]=xt,At=Dt;break}if(At===-1)break}let pt=A[At];pt&&pt.connect(xt)}}function W(X,rt){rt===null?X.matrixWorld.copy(X.matrix):X.matrixWorld.multiplyMatrices(rt.matrixWorld,X.matrix),X.matrixWorldInverse.copy(X.matrixWorld).invert()}this.updateCamera=function(X){if(s===null)return;let rt=X.near,xt=X.far;m.texture!==null&&(m.depthNear>0&&(rt=m.depthNear),m.depthFar>0&&(xt=m.depthFar)),F.near=L.near=T.near=rt,F.far=L.far=T.far=xt,(P!==F.near||B!==F.far)&&(s.updateRenderState({depthNear:F.near,depthFar:F.far}),P=F.near,B=F.far),F.layers.mask=X.layers.mask|6,T.layers.mask=F.layers.mask&-5,L.layers.mask=F.layers.mask&-3;let At=X.parent,pt=F.cameras;W(F,At);for(let Dt=0;Dt<pt.length;Dt++)W(pt[Dt],At);F.projectionMatrix.copy(T.projectionMatrix),F.projectionMatrixInverse.copy(T.projectionMatrixInverse),C===null&&X.isPerspectiveCamera&&(C={camera:X,fov:X.fov,zoom:X.zoom}),Y(X,F,At)};function Y(X,rt,xt){xt===null?X.matrix.copy(rt.matrixWorld):(X.matrix.copy(xt.matrixWorld),X.matrix.invert(),X.matrix.multiply(rt.matrixWorld)),X.matrix.decompose(X.position,X.quaternion,X.scale),X.updateMatrixWorld(!0),X.projectionMatrix.copy(rt.projectionMatrix),X.projectionMatrixInverse.copy(rt.projectionMatrixInverse),X.isPerspectiveCamera&&(X.fov=lr*2*Math.atan(1/X.projectionMatrix.elements[5]),X.zoom=1)}this.getCamera=function(){return F},this.getFoveation=function(){if(!(d===null&&f===null))return c},this.setFoveation=function(X){c=X,d!==null&&(d.fixedFoveation=X),f!==null&&f.fixedFoveation!==void 0&&(f.fixedFoveation=X)},this.hasDepthSensing=function(){return m.texture!==null},this.getDepthSensingMesh=function(){return m.getMesh(F)},this.getCameraTexture=function(X){return g[X]};let tt=null;function gt(X,rt){if(h=rt.getViewerPose(l||o),p=rt,h!==null){let xt=h.views;f!==null&&(t.setRenderTargetFramebuffer(v,f.framebuffer),t.setRenderTarget(v));let At=!1;xt.length!==F.cameras.length&&(F.cameras.length=0,At=!0);for(let Rt=0;Rt<xt.length;Rt++){let Yt=xt[Rt],jt=null;if(f!==null)jt=f.getViewport(Yt);else{let we=u.getViewSubImage(d,Yt);jt=we.viewport,Rt===0&&(t.setRenderTargetTextures(v,we.colorTexture,we.depthStencilTexture),t.setRenderTarget(v))}let kt=N[Rt];kt===void 0&&(kt=new cn,kt.layers.enable(Rt),kt.viewport=new ce,N[Rt]=kt),kt.matrix.fromArray(Yt.transform.matrix),kt.matrix.decompose(kt.position,kt.quaternion,kt.scale),kt.projectionMatrix.fromArray(Yt.projectionMatrix),kt.projectionMatrixInverse.copy(kt.projectionMatrix).invert(),kt.viewport.set(jt.x,jt.y,jt.width,jt.height),Rt===0&&(F.matrix.copy(kt.matrix),F.matrix.decompose(F.position,F.quaternion,F.scale)),At===!0&&F.cameras.push(kt)}let pt=s.enabledFeatures;if(pt&&pt.includes("depth-sensing")&&s.depthUsage=="gpu-optimized"&&x){u=n.getBinding();let Rt=u.getDepthInformation(xt[0]);Rt&&Rt.isValid&&Rt.texture&&m.init(Rt,s.renderState)}if(pt&&pt.includes("camera-access")&&x){t.state.unbindTexture(),u=n.getBinding();for(let Rt=0;Rt<xt.length;Rt++){let Yt=xt[Rt].camera;if(Yt){let jt=g[Yt];jt||(jt=new xo,g[Yt]=jt);let kt=u.getCameraImage(Yt);jt.sourceTexture=kt}}}}for(let xt=0;xt<A.length;xt++){let At=w[xt],pt=A[xt];At!==null&&pt!==void 0&&pt.update(At,rt,l||o)}tt&&tt(X,rt),rt.detectedPlanes&&n.dispatchEvent({type:"planesdetected",data:rt}),p=null}let wt=new yp;wt.setAnimationLoop(gt),this.setAnimationLoop=function(X){tt=X},this.dispose=function(){}}},LM=new te,Cp=new Ot;Cp.set(-1,0,0,0,1,0,0,0,1);function NM(i,t){function e(m,g){m.matrixAutoUpdate===!0&&m.updateMatrix(),g.value.copy(m.matrix)}function n(m,g){g.color.getRGB(m.fogColor.value,gu(i)),g.isFog?(m.fogNear.value=g.near,m.fogFar.value=g.far):g.isFogExp2&&(m.fogDensity.value=g.density)}function s(m,g,y,S,v){g.isNodeMaterial?g.uniformsNeedUpdate=!1:g.isMeshBasicMaterial?r(m,g):g.isMeshLambertMaterial?(r(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshToonMaterial?(r(m,g),u(m,g)):g.isMeshPhongMaterial?(r(m,g),h(m,g),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)):g.isMeshStandardMaterial?(r(m,g),d(m,g),g.isMeshPhysicalMaterial&&f(m,g,v)):g.isMeshMatcapMaterial?(r(m,g),p(m,g)):g.isMeshDepthMaterial?r(m,g):g.isMeshDistanceMaterial?(r(m,g),x(m,g)):g.isMeshNormalMaterial?r(m,g):g.isLineBasicMaterial?(o(m,g),g.isLineDashedMaterial&&a(m,g)):g.isPointsMaterial?c(m,g,y,S):g.isSpriteMaterial?l(m,g):g.isShadowMaterial?(m.color.value.copy(g.color),m.opacity.value=g.opacity):g.isShaderMaterial&&(g.uniformsNeedUpdate=!1)}function r(m,g){m.opacity.value=g.opacity,g.color&&m.diffuse.value.copy(g.color),g.emissive&&m.emissive.value.copy(g.emissive).multiplyScalar(g.emissiveIntensity),g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.bumpMap&&(m.bumpMap.value=g.bumpMap,e(g.bumpMap,m.bumpMapTransform),m.bumpScale.value=g.bumpScale,g.side===un&&(m.bumpScale.value*=-1)),g.normalMap&&(m.normalMap.value=g.normalMap,e(g.normalMap,m.normalMapTransform),m.normalScale.value.copy(g.normalScale),g.side===un&&m.normalScale.value.negate()),g.displacementMap&&(m.displacementMap.value=g.displacementMap,e(g.displacementMap,m.displacementMapTransform),m.displacementScale.value=g.displacementScale,m.displacementBias.value=g.displacementBias),g.emissiveMap&&(m.emissiveMap.value=g.emissiveMap,e(g.emissiveMap,m.emissiveMapTransform)),g.specularMap&&(m.specularMap.value=g.specularMap,e(g.specularMap,m.specularMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest);let y=t.get(g),S=y.envMap,v=y.envMapRotation;S&&(m.envMap.value=S,m.envMapRotation.value.setFromMatrix4(LM.makeRotationFromEuler(v)).transpose(),S.isCubeTexture&&S.isRenderTargetTexture===!1&&m.envMapRotation.value.premultiply(Cp),m.reflectivity.value=g.reflectivity,m.ior.value=g.ior,m.refractionRatio.value=g.refractionRatio),g.lightMap&&(m.lightMap.value=g.lightMap,m.lightMapIntensity.value=g.lightMapIntensity,e(g.lightMap,m.lightMapTransform)),g.aoMap&&(m.aoMap.value=g.aoMap,m.aoMapIntensity.value=g.aoMapIntensity,e(g.aoMap,m.aoMapTransform))}function o(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform))}function a(m,g){m.dashSize.value=g.dashSize,m.totalSize.value=g.dashSize+g.gapSize,m.scale.value=g.scale}function c(m,g,y,S){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.size.value=g.size*y,m.scale.value=S*.5,g.map&&(m.map.value=g.map,e(g.map,m.uvTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function l(m,g){m.diffuse.value.copy(g.color),m.opacity.value=g.opacity,m.rotation.value=g.rotation,g.map&&(m.map.value=g.map,e(g.map,m.mapTransform)),g.alphaMap&&(m.alphaMap.value=g.alphaMap,e(g.alphaMap,m.alphaMapTransform)),g.alphaTest>0&&(m.alphaTest.value=g.alphaTest)}function h(m,g){m.specular.value.copy(g.specular),m.shininess.value=Math.max(g.shininess,1e-4)}function u(m,g){g.gradientMap&&(m.gradientMap.value=g.gradientMap)}function d(m,g){m.metalness.value=g.metalness,g.metalnessMap&&(m.metalnessMap.value=g.metalnessMap,e(g.metalnessMap,m.metalnessMapTransform)),m.roughness.value=g.roughness,g.roughnessMap&&(m.roughnessMap.value=g.roughnessMap,e(g.roughnessMap,m.roughnessMapTransform)),g.envMap&&(m.envMapIntensity.value=g.envMapIntensity)}function f(m,g,y){m.ior.value=g.ior,g.diffuseRoughness>0&&(m.diffuseRoughness.value=g.diffuseRoughness,g.diffuseRoughnessMap&&(m.diffuseRoughnessMap.value=g.diffuseRoughnessMap,e(g.diffuseRoughnessMap,m.diffuseRoughnessMapTransform))),g.sheen>0&&(m.sheenColor.value.copy(g.sheenColor).multiplyScalar(g.sheen),m.sheenRoughness.value=g.sheenRoughness,g.sheenColorMap&&(m.sheenColorMap.value=g.sheenColorMap,e(g.sheenColorMap,m.sheenColorMapTransform)),g.sheenRoughnessMap&&(m.sheenRoughnessMap.value=g.sheenRoughnessMap,e(g.sheenRoughnessMap,m.sheenRoughnessMapTransform))),g.clearcoat>0&&(m.clearcoat.value=g.clearcoat,m.clearcoatRoughness.value=g.clearcoatRoughness,g.clearcoatMap&&(m.clearcoatMap.value=g.clearcoatMap,e(g.clearcoatMap,m.clearcoatMapTransform)),g.clearcoatRoughnessMap&&(m.clearcoatRoughnessMap.value=g.clearcoatRoughnessMap,e(g.clearcoatRoughnessMap,m.clearcoatRoughnessMapTransform)),g.clearcoatNormalMap&&(m.clearcoatNormalMap.value=g.clearcoatNormalMap,e(g.clearcoatNormalMap,m.clearcoatNormalMapTransform),m.clearcoatNormalScale.value.copy(g.clearcoatNormalScale),g.side===un&&m.clearcoatNormalScale.value.negate())),g.dispersion>0&&(m.dispersion.value=g.dispersion),g.retroreflectivity>0&&(m.retroreflectivity.value=g.retroreflectivity),g.iridescence>0&&(m.iridescence.value=g.iridescence,m.iridescenceIOR.value=g.iridescenceIOR,m.iridescenceThicknessMinimum.value=g.iridescenceThicknessMinimum,m.iridescenceThicknessMaximum.value=g.iridescenceThicknessMaximum,g.iridescenceMap&&(m.iridescenceMap.value=g.iridescenceMap,e(g.iridescenceMap,m.iridescenceMapTransform)),g.iridescenceThicknessMap&&(m.iridescenceThicknessMap.value=g.iridescenceThicknessMap,e(g.iridescenceThicknessMap,m.iridescenceThicknessMapTransform))),g.transmission>0&&(m.transmission.value=g.transmission,m.transmissionSamplerMap.value=y.texture,m.transmissionSamplerSize.value.set(y.width,y.height),g.transmissionMap&&(m.transmissionMap.value=g.transmissionMap,e(g.transmissionMap,m.transmissionMapTransform)),m.thickness.value=g.thickness,g.thicknessMap&&(m.thicknessMap.value=g.thicknessMap,e(g.thicknessMap,m.thicknessMapTransform)),m.attenuationDistance.value=g.attenuationDistance,m.attenuationColor.value.copy(g.attenuationColor)),g.anisotropy>0&&(m.anisotropyVector.value.set(g.anisotropy*Math.cos(g.anisotropyRotation),g.anisotropy*Math.sin(g.anisotropyRotation)),g.anisotropyMap&&(m.anisotropyMap.value=g.anisotropyMap,e(g.anisotropyMap,m.anisotropyMapTransform))),m.specularIntensity.value=g.specularIntensity,m.specularColor.value.copy(g.specularColor),g.specularColorMap&&(m.specularColorMap.value=g.specularColorMap,e(g.specularColorMap,m.specularColorMapTransform)),g.specularIntensityMap&&(m.specularIntensityMap.value=g.specularIntensityMap,e(g.specularIntensityMap,m.specularIntensityMapTransform))}function p(m,g){g.matcap&&(m.matcap.value=g.matcap)}function x(m,g){let y=t.get(g).light;m.referencePosition.value.setFromMatrixPosition(y.matrixWorld),m.nearDistance.value=y.shadow.camera.near,m.farDistance.value=y.shadow.camera.far}return{refreshFogUniforms:n,refreshMaterialUniforms:s}}function DM(i,t,e,n){let s={},r={};function o(y,S){let v=S.program;n.uniformBlockBinding(y,v,s[y.id])}function a(y,S){let v=s[y.id];v===void 0&&(p(y),v=c(y),s[y.id]=v,y.addEventListener("dispose",m));let A=S.program;n.updateUBOMapping(y,A);let w=t.render.frame;r[y.id]!==w&&(l(y),r[y.id]=w)}function c(y){let S=i.createBuffer(),v=y.__size,A=y.usage;return i.bindBuffer(i.UNIFORM_BUFFER,S),i.bufferData(i.UNIFORM_BUFFER,v,A),i.bindBuffer(i.UNIFORM_BUFFER,null),S}function l(y){let S=s[y.id],v=y.uniforms,A=y.__cache;i.bindBuffer(i.UNIFORM_BUFFER,S);for(let w=0,_=v.length;w<_;w++){let M=v[w];if(Array.isArray(M))for(let C=0,T=M.length;C<T;C++)h(M[C],w,C,A);else h(M,w,0,A)}i.bindBuffer(i.UNIFORM_BUFFER,null)}function h(y,S,v,A){if(d(y,S,v,A)===!0){let w=y.__offset,_=y.value;if(Array.isArray(_)){let M=0;for(let C=0;C<_.length;C++){let T=_[C],L=x(T,!0);u(T,y.__data,M),M+=L.storage/Float32Array.BYTES_PER_ELEMENT}}else u(_,y.__data,0);i.bufferSubData(i.UNIFORM_BUFFER,w,y.__data)}}function u(y,S,v){typeof y=="number"||typeof y=="boolean"?S[v]=y:y.isMatrix3?(S[v]=y.elements[0],S[v+1]=y.elements[1],S[v+2]=y.elements[2],S[v+3]=0,S[v+4]=y.elements[3],S[v+5]=y.elements[4],S[v+6]=y.elements[5],S[v+7]=0,S[v+8]=y.elements[6],S[v+9]=y.elements[7],S[v+10]=y.elements[8],S[v+11]=0):ArrayBuffer.isView(y)?S.set(y.subarray(0,S.length-v),v):y.toArray(S,v)}function d(y,S,v,A){let w=y.value,_=S+"_"+v;if(Array.isArray(w)){A[_]===void 0&&(A[_]=[]);let M=A[_],C=!1;for(let T=0;T<w.length;T++)f(w[T],M,T)===!0&&(C=!0);return C}return f(w,A,_)}function f(y,S,v){if(S[v]===void 0)return typeof y=="number"||typeof y=="boolean"?S[v]=y:ArrayBuffer.isView(y)?S[v]=y.slice():S[v]=y.clone(),!0;{let A=S[v];if(typeof y=="number"||typeof y=="boolean"){if(A!==y)return S[v]=y,!0}else{if(ArrayBuffer.isView(y))return!0;if(A.equals(y)===!1)return A.copy(y),!0}}return!1}function p(y){let S=y.uniforms,v=0,A=16;for(let _=0,M=S.length;_<M;_++){let C=Array.isArray(S[_])?S[_]:[S[_]];for(let T=0,L=C.length;T<L;T++){let N=C[T],F=Array.isArray(N.value)?N.value:[N.value],P=Array.isArray(S[_])||Array.isArray(N.value),B=v;for(let H=0,j=F.length;H<j;H++){let W=F[H],Y=x(W,P),tt=v%A,gt=tt%Y.boundary,wt=tt+gt;v+=gt,wt!==0&&A-wt<Y.storage&&(v+=A-wt),H===0&&(B=v),v+=Y.storage}let G=N.type==="int"?Int32Array:N.type==="uint"?Uint32Array:Float32Array;N.__data=new G((v-B)/Float32Array.BYTES_PER_ELEMENT),N.__offset=B}}let w=v%A;return w>0&&(v+=A-w),y.__size=v,y.__cache={},this}function x(y,S){let v={boundary:0,storage:0};return typeof y=="number"||typeof y=="boolean"?(v.boundary=4,v.storage=4):y.isVector2?(v.boundary=8,v.storage=8):y.isVector3||y.isColor?(v.boundary=16,v.storage=12):y.isVector4?(v.boundary=16,v.storage=16):y.isMatrix3?(v.boundary=16,v.storage=48):y.isMatrix4?(v.boundary=16,v.storage=64):y.isTexture?It("WebGLRenderer: Texture samplers can not be part of an uniforms group."):ArrayBuffer.isView(y)?(v.boundary=16,v.storage=y.byteLength):It("WebGLRenderer: Unsupported uniform value type.",y),S===!0&&(v.boundary=16,v.storage=Math.ceil(v.storage/16)*16),v}function m(y){let S=y.target;S.removeEventListener("dispose",m),i.deleteBuffer(s[S.id]),delete s[S.id],delete r[S.id]}function g(){for(let y in s)i.deleteBuffer(s[y]);s={},r={}}return{bind:o,update:a,dispose:g}}var UM=new Uint16Array([12469,15057,12620,14925,13266,14620,13807,14376,14323,13990,14545,13625,14713,13328,14840,12882,14931,12528,14996,12233,15039,11829,15066,11525,15080,11295,15085,10976,15082,10705,15073,10495,13880,14564,13898,14542,13977,14430,14158,14124,14393,13732,14556,13410,14702,12996,14814,12596,14891,12291,14937,11834,14957,11489,14958,11194,14943,10803,14921,10506,14893,10278,14858,9960,14484,14039,14487,14025,14499,13941,14524,13740,14574,13468,14654,13106,14743,12678,14818,12344,14867,11893,14889,11509,14893,11180,14881,10751,14852,10428,14812,10128,14765,9754,14712,9466,14764,13480,14764,13475,14766,13440,14766,13347,14769,13070,14786,12713,14816,12387,14844,11957,14860,11549,14868,11215,14855,10751,14825,10403,14782,10044,14729,9651,14666,9352,14599,9029,14967,12835,14966,12831,14963,12804,14954,12723,14936,12564,14917,12347,14900,11958,14886,11569,14878,11247,14859,10765,14828,10401,14784,10011,14727,9600,14660,9289,14586,8893,14508,8533,15111,12234,15110,12234,15104,12216,15092,12156,15067,12010,15028,11776,14981,11500,14942,11205,14902,10752,14861,10393,14812,9991,14752,9570,14682,9252,14603,8808,14519,8445,14431,8145,15209,11449,15208,11451,15202,11451,15190,11438,15163,11384,15117,11274,15055,10979,14994,10648,14932,10343,14871,9936,14803,9532,14729,9218,14645,8742,14556,8381,14461,8020,14365,7603,15273,10603,15272,10607,15267,10619,15256,10631,15231,10614,15182,10535,15118,10389,15042,10167,14963,9787,14883,9447,14800,9115,14710,8665,14615,8318,14514,7911,14411,7507,14279,7198,15314,9675,15313,9683,15309,9712,15298,9759,15277,9797,15229,9773,15166,9668,15084,9487,14995,9274,14898,8910,14800,8539,14697,8234,14590,7790,14479,7409,14367,7067,14178,6621,15337,8619,15337,8631,15333,8677,15325,8769,15305,8871,15264,8940,15202,8909,15119,8775,15022,8565,14916,8328,14804,8009,14688,7614,14569,7287,14448,6888,14321,6483,14088,6171,15350,7402,15350,7419,15347,7480,15340,7613,15322,7804,15287,7973,15229,8057,15148,8012,15046,7846,14933,7611,14810,7357,14682,7069,14552,6656,14421,6316,14251,5948,14007,5528,15356,5942,15356,5977,15353,6119,15348,6294,15332,6551,15302,6824,15249,7044,15171,7122,15070,7050,14949,6861,14818,6611,14679,6349,14538,6067,14398,5651,14189,5311,13935,4958,15359,4123,15359,4153,15356,4296,15353,4646,15338,5160,15311,5508,15263,5829,15188,6042,15088,6094,14966,6001,14826,5796,14678,5543,14527,5287,14377,4985,14133,4586,13869,4257,15360,1563,15360,1642,15358,2076,15354,2636,15341,3350,15317,4019,15273,4429,15203,4732,15105,4911,14981,4932,14836,4818,14679,4621,14517,4386,14359,4156,14083,3795,13808,3437,15360,122,15360,137,15358,285,15355,636,15344,1274,15322,2177,15281,2765,15215,3223,15120,3451,14995,3569,14846,3567,14681,3466,14511,3305,14344,3121,14037,2800,13753,2467,15360,0,15360,1,15359,21,15355,89,15346,253,15325,479,15287,796,15225,1148,15133,1492,15008,1749,14856,1882,14685,1886,14506,1783,14324,1608,13996,1398,13702,1183]),di=null;function OM(){return di===null&&(di=new Ii(UM,16,16,rs,Qn),di.name="DFG_LUT",di.minFilter=Oe,di.magFilter=Oe,di.wrapS=ai,di.wrapT=ai,di.generateMipmaps=!1,di.needsUpdate=!0),di}var fl=class{constructor(t={}){let{canvas:e=qf(),context:n=null,depth:s=!0,stencil:r=!1,alpha:o=!1,antialias:a=!1,premultipliedAlpha:c=!0,preserveDrawingBuffer:l=!1,powerPreference:h="default",failIfMajorPerformanceCaveat:u=!1,reversedDepthBuffer:d=!1,outputBufferType:f=_n}=t;this.isWebGLRenderer=!0;let p;if(n!==null){if(typeof WebGLRenderingContext<"u"&&n instanceof WebGLRenderingContext)throw new Error("THREE.WebGLRenderer: WebGL 1 is not supported since r163.");p=n.getContextAttributes().alpha}else p=o;let x=f,m=new Set([Pc,Cc,Rc]),g=new Set([_n,jn,Mr,Os,Ac,Ec]),y=new Uint32Array(4),S=new Int32Array(4),v={textures:[],min:[],max:[],resolution:[]},A=null,w=null,_=[],M=[],C=null;this.domElement=e,this.debug={checkShaderErrors:!0,diagnostics:{keywords:!1},onShaderError:null},this.autoClear=!0,this.autoClearColor=!0,this.autoClearDepth=!0,this.autoClearStencil=!0,this.sortObjects=!0,this.clippingPlanes=[],this.localClippingEnabled=!1,this.toneMapping=ui,this.toneMappingExposure=1,this.transmissionResolutionScale=1;let T=this,L=!1,N=null,F=null,P=null,B=null;this._outputColorSpace=wn;let G=0,H=0,j=null,W=-1,Y=null,tt=new ce,gt=new ce,wt=null,X=new zt(0),rt=0,xt=e.width,At=e.height,pt=1,Dt=null,fe=null,Rt=new ce(0,0,xt,At),Yt=new ce(0,0,xt,At),jt=!1,kt=new Ki,we=new ec,xe=!1,ie=!1,pe=new te,Mn=new I,Ce=new ce,rn={background:null,fog:null,environment:null,overrideMaterial:null,isScene:!0},Dn=!1;function Un(){return j===null?pt:1}let O=n;function On(E,U){return e.getContext(E,U)}let ve,Me,mt,Ue,Lt,Ft,R,b,k,et,Q,ot,ut,Z,J,ct,D,K,$,lt,it,at,Ct;try{let E={alpha:!0,depth:s,stencil:r,antialias:a,premultipliedAlpha:c,preserveDrawingBuffer:l,powerPreference:h,failIfMajorPerformanceCaveat:u};if("setAttribute"in e&&e.setAttribute("data-engine",`three.js r${"187"}`),e.addEventListener("webglcontextlost",Pt,!1),e.addEventListener("webglcontextrestored",Ht,!1),e.addEventListener("webglcontextcreationerror",_t,!1),O===null){let U="webgl2";if(O=On(U,E),O===null)throw On(U)?new Error("THREE.WebGLRenderer: Error creating WebGL context with your selected attributes."):new Error("THREE.WebGLRenderer: Error creating WebGL context.")}qt()}catch(E){throw e.removeEventListener("webglcontextlost",Pt,!1),e.removeEventListener("webglcontextrestored",Ht,!1),e.removeEventListener("webglcontextcreationerror",_t,!1),Ut("WebGLRenderer: "+E.message),E}function qt(){ve=new $y(O),ve.init(),it=new CM(O,ve),Me=new Oy(O,ve,t,it),mt=new TM(O,ve),Me.reversedDepthBuffer&&d&&mt.buffers.depth.setReversed(!0),F=O.createFramebuffer(),P=O.createFramebuffer(),B=O.createFramebuffer(),Ue=new Jy(O),Lt=new fM,Ft=new RM(O,ve,mt,Lt,Me,it,Ue),R=new Xy(T),b=new j0(O),at=new Dy(O,b),k=new Yy(O,b,Ue,at),et=new jy(O,k,b,at,Ue),K=new Ky(O,Me,Ft),J=new Fy(Lt),Q=new dM(T,R,ve,Me,at,J),ot=new NM(T,Lt),ut=new mM,Z=new MM(ve),D=new Ny(T,R,mt,et,p,c),ct=new EM(T,et,Me),Ct=new DM(O,Ue,Me,mt),$=new Uy(O,ve,Ue),lt=new Zy(O,ve,Ue),Ue.programs=Q.programs,T.capabilities=Me,T.extensions=ve,T.properties=Lt,T.renderLists=ut,T.shadowMap=ct,T.state=mt,T.info=Ue}x!==_n&&(C=new tv(x,e.width,e.height,a,s,r));let nt=new Cu(T,O);this.xr=nt,this.getContext=function(){return O},this.getContextAttributes=function(){return O.getContextAttributes()},this.forceContextLoss=function(){let E=ve.get("WEBGL_lose_context");E&&E.loseContext()},this.forceContextRestore=function(){let E=ve.get("WEBGL_lose_context");E&&E.restoreContext()},this.getPixelRatio=function(){return pt},this.setPixelRatio=function(E){E!==void 0&&(pt=E,this.setSize(xt,At,!1))},this.getSize=function(E){return E.set(xt,At)},this.setSize=function(E,U,q=!0){if(nt.isPresenting){It("WebGLRenderer: Can't change size while VR device is presenting.");return}xt=E,At=U,e.width=Math.floor(E*pt),e.height=Math.floor(U*pt),q===!0&&(e.style.width=E+"px",e.style.height=U+"px"),C!==null&&C.setSize(e.width,e.height),this.setViewport(0,0,E,U)},this.getDrawingBufferSize=function(E){return E.set(xt*pt,At*pt).floor()},this.setDrawingBufferSize=function(E,U,q){xt=E,At=U,pt=q,e.width=Math.floor(E*q),e.height=Math.floor(U*q),this.setViewport(0,0,E,U)},this.setEffects=function(E){if(x===_n){Ut("WebGLRenderer: setEffects() requires outputBufferType set to HalfFloatType or FloatType.");return}if(E){for(let U=0;U<E.length;U++)if(E[U].isOutputPass===!0){It("WebGLRenderer: OutputPass is not needed in setEffects(). Tone mapping and color space conversion are applied automatically.");break}}C.setEffects(E||[])},this.getCurrentViewport=function(E){return E.copy(tt)},this.getViewport=function(E){return E.copy(Rt)},this.setViewport=function(E,U,q,z){E.isVector4?Rt.set(E.x,E.y,E.z,E.w):Rt.set(E,U,q,z),mt.viewport(tt.copy(Rt).multiplyScalar(Un()).round())},this.getScissor=function(E){return E.copy(Yt)},this.setScissor=function(E,U,q,z){E.isVector4?Yt.set(E.x,E.y,E.z,E.w):Yt.set(E,U,q,z),mt.scissor(gt.copy(Yt).multiplyScalar(Un()).round())},this.getScissorTest=function(){return jt},this.setScissorTest=function(E){mt.setScissorTest(jt=E)},this.setOpaqueSort=function(E){Dt=E},this.setTransparentSort=function(E){fe=E},this.getClearColor=function(E){return E.copy(D.getClearColor())},this.setClearColor=function(){D.setClearColor(...arguments)},this.getClearAlpha=function(){return D.getClearAlpha()},this.setClearAlpha=function(){D.setClearAlpha(...arguments)},this.clear=function(E=!0,U=!0,q=!0){let z=0;if(E){let V=!1;if(j!==null){let dt=j.texture.format;V=m.has(dt)}if(V){let dt=j.texture.type,Mt=g.has(dt),ht=D.getClearColor(),yt=D.getClearAlpha(),Et=ht.r,Bt=ht.g,Zt=ht.b;Mt?(y[0]=Et,y[1]=Bt,y[2]=Zt,y[3]=yt,O.clearBufferuiv(O.COLOR,0,y)):(S[0]=Et,S[1]=Bt,S[2]=Zt,S[3]=yt,O.clearBufferiv(O.COLOR,0,S))}else z|=O.COLOR_BUFFER_BIT}U&&(z|=O.DEPTH_BUFFER_BIT,this.state.buffers.depth.setMask(!0)),q&&(z|=O.STENCIL_BUFFER_BIT,this.state.buffers.stencil.setMask(4294967295)),z!==0&&O.clear(z)},this.clearColor=function(){this.clear(!0,!1,!1)},this.clearDepth=function(){this.clear(!1,!0,!1)},this.clearStencil=function(){this.clear(!1,!1,!0)},this.setNodesHandler=function(E){E.setRenderer(this),N=E},this.dispose=function(){e.removeEventListener("webglcontextlost",Pt,!1),e.removeEventListener("webglcontextrestored",Ht,!1),e.removeEventListener("webglcontextcreationerror",_t,!1),D.dispose(),ut.dispose(),Z.dispose(),Ft.dispose(),Lt.dispose(),R.dispose(),et.dispose(),k.dispose(),at.dispose(),Ct.dispose(),Q.dispose(),nt.dispose(),nt.removeEventListener("sessionstart",vd),nt.removeEventListener("sessionend",Md),ws.stop()};function Pt(E){E.preventDefault(),ro("WebGLRenderer: Context Lost."),L=!0}function Ht(){ro("WebGLRenderer: Context Restored."),L=!1;let E=Ue.autoReset,U=ct.enabled,q=ct.autoUpdate,z=ct.needsUpdate,V=ct.type;qt(),Ue.autoReset=E,ct.enabled=U,ct.autoUpdate=q,ct.needsUpdate=z,ct.type=V}function _t(E){Ut("WebGLRenderer: A WebGL context could not be created. Reason: ",E.statusMessage)}function le(E){let U=E.target;U.removeEventListener("dispose",le),ke(U)}function ke(E){Hi(E),Lt.remove(E)}function Hi(E){let U=Lt.get(E).programs;U!==void 0&&(U.forEach(function(q){Q.releaseProgram(q)}),E.isShaderMaterial&&Q.releaseShaderCache(E))}this.renderBufferDirect=function(E,U,q,z,V,dt){U===null&&(U=rn);let Mt=V.isMesh&&V.matrixWorld.determinantAffine()<0,ht=Wg(E,U,q,z,V);mt.setMaterial(z,Mt);let yt=q.index,Et=1;if(z.wireframe===!0){if(yt=k.getWireframeAttribute(q),yt===void 0)return;Et=2}let Bt=q.drawRange,Zt=q.attributes.position,St=Bt.start*Et,Jt=(Bt.start+Bt.count)*Et;dt!==null&&(St=Math.max(St,dt.start*Et),Jt=Math.min(Jt,(dt.start+dt.count)*Et)),yt!==null?(St=Math.max(St,0),Jt=Math.min(Jt,yt.count)):Zt!=null&&(St=Math.max(St,0),Jt=Math.min(Jt,Zt.count));let Le=Jt-St;if(Le<0||Le===1/0)return;at.setup(V,z,ht,q,yt);let me,de=$;if(yt!==null&&(me=b.get(yt),de=lt,de.setIndex(me)),V.isMesh)z.wireframe===!0?(mt.setLineWidth(z.wireframeLinewidth*Un()),de.setMode(O.LINES)):de.setMode(O.TRIANGLES);else if(V.isLine){let Qe=z.linewidth;Qe===void 0&&(Qe=1),mt.setLineWidth(Qe*Un()),V.isLineSegments?de.setMode(O.LINES):V.isLineLoop?de.setMode(O.LINE_LOOP):de.setMode(O.LINE_STRIP)}else V.isPoints?de.setMode(O.POINTS):V.isSprite&&de.setMode(O.TRIANGLES);if(V.isBatchedMesh)if(ve.get("WEBGL_multi_draw"))de.renderMultiDraw(V._multiDrawStarts,V._multiDrawCounts,V._multiDrawCount);else{let Qe=V._multiDrawStarts,bt=V._multiDrawCounts,on=V._multiDrawCount,se=yt?b.get(yt).bytesPerElement:1,As=Lt.get(z).currentProgram.getUniforms();for(let tn=0;tn<on;tn++)As.setValue(O,"_gl_DrawID",tn),de.render(Qe[tn]/se,bt[tn])}else if(V.isInstancedMesh)de.renderInstances(St,Le,V.count);else if(q.isInstancedBufferGeometry){let Qe=q._maxInstanceCount!==void 0?q._maxInstanceCount:1/0,bt=Math.min(q.instanceCount,Qe);de.renderInstances(St,Le,bt)}else de.render(St,Le)};function yd(E,U,q,z){N!==null&&E.isNodeMaterial&&N.setObject(z,E),xe===!0&&J.setState(E,q,!1),E.transparent===!0&&E.side===hi&&E.forceSinglePass===!1?(E.side=un,E.needsUpdate=!0,qr(E,U,z),E.side=ss,E.needsUpdate=!0,qr(E,U,z),E.side=hi):qr(E,U,z)}this.compile=function(E,U,q=null){q===null&&(q=E),N!==null&&N.renderStart(E,U,q),w=Z.get(q),w.init(U),M.push(w),q.traverseVisible(function(V){V.isLight&&V.layers.test(U.layers)&&(w.pushLight(V),V.castShadow&&w.pushShadow(V))}),E!==q&&E.traverseVisible(function(V){V.isLight&&V.layers.test(U.layers)&&(w.pushLight(V),V.castShadow&&w.pushShadow(V))}),w.setupLights(),N!==null&&N.updateLights(w.state.lightsArray),ie=this.localClippingEnabled,xe=J.init(this.clippingPlanes,ie),xe===!0&&J.setGlobalState(this.clippingPlanes,U),N!==null&&ct.render(w.state.shadowsArray,q,U);let z=new Set;return E.traverse(function(V){if(!(V.isMesh||V.isPoints||V.isLine||V.isSprite))return;let dt=V.material;if(dt)if(Array.isArray(dt))for(let Mt=0;Mt<dt.length;Mt++){let ht=dt[Mt];yd(ht,q,U,V),z.add(ht)}else yd(dt,q,U,V),z.add(dt)}),w=M.pop(),N!==null&&N.renderEnd(),z},this.compileAsync=function(E,U,q=null){let z=this.compile(E,U,q);return new Promise(V=>{function dt(){if(z.forEach(function(Mt){let yt=Lt.get(Mt).currentProgram;(yt===void 0||yt.isReady())&&z.delete(Mt)}),z.size===0){V(E);return}setTimeout(dt,10)}ve.get("KHR_parallel_shader_compile")!==null?dt():setTimeout(dt,10)})};let ch=null;function Vg(E){ch&&ch(E)}function vd(){ws.stop()}function Md(){ws.start()}let ws=new yp;ws.setAnimationLoop(Vg),typeof self<"u"&&ws.setContext(self),this.setAnimationLoop=function(E){ch=E,nt.setAnimationLoop(E),E===null?ws.stop():ws.start()},nt.addEventListener("sessionstart",vd),nt.addEventListener("sessionend",Md),this.render=function(E,U){if(U!==void 0&&U.isCamera!==!0){Ut("WebGLRenderer.render: camera is not an instance of THREE.Camera.");return}if(L===!0)return;N!==null&&N.renderStart(E,U);let q=nt.enabled===!0&&nt.isPresenting===!0,z=C!==null&&(j===null||q)&&C.begin(T,j);if(E.matrixWorldAutoUpdate===!0&&E.updateMatrixWorld(),U.parent===null&&U.matrixWorldAutoUpdate===!0&&U.updateMatrixWorld(),nt.enabled===!0&&nt.isPresenting===!0&&(C===null||C.isCompositing()===!1)&&(nt.cameraAutoUpdate===!0&&nt.updateCamera(U),U=nt.getCamera()),E.isScene===!0&&E.onBeforeRender(T,E,U,j),w=Z.get(E,M.length),w.init(U),w.state.textureUnits=Ft.getTextureUnits(),M.push(w),pe.multiplyMatrices(U.projectionMatrix,U.matrixWorldInverse),U.isArrayCamera?we.setFromArrayCamera(U):kt.setFromProjectionMatrix(pe,Bn,U.reversedDepth),ie=this.localClippingEnabled,xe=J.init(this.clippingPlanes,ie),A=ut.get(E,_.length),A.init(),_.push(A),this.info.render.frame++,nt.enabled===!0&&nt.isPresenting===!0){let Mt=T.xr.getDepthSensingMesh();Mt!==null&&lh(Mt,U,-1/0,T.sortObjects)}lh(E,U,0,T.sortObjects),A.finish(),N!==null&&N.updateLights(w.state.lightsArray),T.sortObjects===!0&&A.sort(Dt,fe),Dn=nt.enabled===!1||nt.isPresenting===!1||nt.hasDepthSensing()===!1,Dn&&D.addToRenderList(A,E),this.info.autoReset===!0&&this.info.reset(),xe===!0&&J.beginShadows();let V=w.state.shadowsArray;if(ct.render(V,E,U),xe===!0&&J.endShadows(),(z&&C.hasRenderPass())===!1){let Mt=A.opaque,ht=A.transmissive;if(w.setupLights(),U.isArrayCamera){let yt=U.cameras;if(ht.length>0)for(let Et=0,Bt=yt.length;Et<Bt;Et++){let Zt=yt[Et];bd(Mt,ht,E,Zt)}Dn&&D.render(E);for(let Et=0,Bt=yt.length;Et<Bt;Et++){let Zt=yt[Et];Sd(A,E,Zt,Zt.viewport)}}else ht.length>0&&bd(Mt,ht,E,U),Dn&&D.render(E),Sd(A,E,U)}j!==null&&H===0&&(Ft.updateMultisampleRenderTarget(j),Ft.updateRenderTargetMipmap(j)),z&&C.end(T),E.isScene===!0&&E.onAfterRender(T,E,U),at.resetDefaultState(),W=-1,Y=null,M.pop(),M.length>0?(w=M[M.length-1],Ft.setTextureUnits(w.state.textureUnits),xe===!0&&J.setGlobalState(T.clippingPlanes,w.state.camera)):w=null,_.pop(),_.length>0?A=_[_.length-1]:A=null,N!==null&&N.renderEnd()};function lh(E,U,q,z){if(E.visible===!1)return;if(E.layers.test(U.layers)){if(E.isGroup)q=E.renderOrder;else if(E.isLOD)E.autoUpdate===!0&&E.update(U);else if(E.isLight)w.pushLight(E),E.castShadow&&w.pushShadow(E);else if(E.isSprite){let Mt=U.isArrayCamera?we:kt;if(!E.frustumCulled||E.intersectsFrustum(Mt)){z&&Ce.setFromMatrixPosition(E.matrixWorld).applyMatrix4(pe);let ht=et.update(E),yt=E.material;yt.visible&&A.push(E,ht,yt,q,Ce.z,null,U)}}else if(E.isMesh||E.isLine||E.isPoints){let Mt=U.isArrayCamera?we:kt;if(!E.frustumCulled||E.intersectsFrustum(Mt)){let ht=et.update(E),yt=E.material;if(z&&(E.boundingSphere!==void 0?(E.boundingSphere===null&&E.computeBoundingSphere(),Ce.copy(E.boundingSphere.center)):(ht.boundingSphere===null&&ht.computeBoundingSphere(),Ce.copy(ht.boundingSphere.center)),Ce.applyMatrix4(E.matrixWorld).applyMatrix4(pe)),Array.isArray(yt)){let Et=ht.groups;for(let Bt=0,Zt=Et.length;Bt<Zt;Bt++){let St=Et[Bt],Jt=yt[St.materialIndex];Jt&&Jt.visible&&A.push(E,ht,Jt,q,Ce.z,St,U)}}else yt.visible&&A.push(E,ht,yt,q,Ce.z,null,U)}}}let dt=E.children;for(let Mt=0,ht=dt.length;Mt<ht;Mt++)lh(dt[Mt],U,q,z)}function Sd(E,U,q,z){let{opaque:V,transmissive:dt,transparent:Mt}=E;w.setupLightsView(q),xe===!0&&J.setGlobalState(T.clippingPlanes,q),z&&mt.viewport(tt.copy(z)),V.length>0&&ca(V,U,q),dt.length>0&&ca(dt,U,q),Mt.length>0&&ca(Mt,U,q),mt.buffers.depth.setTest(!0),mt.buffers.depth.setMask(!0),mt.buffers.color.setMask(!0),mt.setPolygonOffset(!1)}function bd(E,U,q,z){if((q.isScene===!0?q.overrideMaterial:null)!==null)return;if(w.state.transmissionRenderTarget[z.id]===void 0){let St=ve.has("EXT_color_buffer_half_float")||ve.has("EXT_color_buffer_float");w.state.transmissionRenderTarget[z.id]=new An(1,1,{generateMipmaps:!0,type:St?Qn:_n,minFilter:Di,samples:Math.max(4,Me.samples),stencilBuffer:r,resolveDepthBuffer:!1,resolveStencilBuffer:!1,storeMultisampledDepthBuffer:!1,storeMultisampledStencilBuffer:!1,colorSpace:Kt.workingColorSpace})}let dt=w.state.transmissionRenderTarget[z.id],Mt=z.viewport||tt;dt.setSize(Mt.z*T.transmissionResolutionScale,Mt.w*T.transmissionResolutionScale);let ht=T.getRenderTarget(),yt=T.getActiveCubeFace(),Et=T.getActiveMipmapLevel();T.setRenderTarget(dt),T.getClearColor(X),rt=T.getClearAlpha(),rt<1&&T.setClearColor(16777215,.5),T.clear(),Dn&&D.render(q);let Bt=T.toneMapping;T.toneMapping=ui;let Zt=z.viewport;if(z.viewport!==void 0&&(z.viewport=void 0),w.setupLightsView(z),xe===!0&&J.setGlobalState(T.clippingPlanes,z),ca(E,q,z),Ft.updateMultisampleRenderTarget(dt),Ft.updateRenderTargetMipmap(dt),ve.has("WEBGL_multisampled_render_to_texture")===!1){let St=!1;for(let Jt=0,Le=U.length;Jt<Le;Jt++){let me=U[Jt],{object:de,geometry:Qe,material:bt,group:on}=me;if(bt.side===hi&&de.layers.test(z.layers)){let se=bt.side;bt.side=un,bt.needsUpdate=!0,wd(de,q,z,Qe,bt,on),bt.side=se,bt.needsUpdate=!0,St=!0}}St===!0&&(Ft.updateMultisampleRenderTarget(dt),Ft.updateRenderTargetMipmap(dt))}T.setRenderTarget(ht,yt,Et),T.setClearColor(X,rt),Zt!==void 0&&(z.viewport=Zt),T.toneMapping=Bt}function ca(E,U,q){let z=U.isScene===!0?U.overrideMaterial:null;for(let V=0,dt=E.length;V<dt;V++){let Mt=E[V],{object:ht,geometry:yt,group:Et}=Mt,Bt=Mt.material;Bt.allowOverride===!0&&z!==null&&(Bt=z),ht.layers.test(q.layers)&&wd(ht,U,q,yt,Bt,Et)}}function wd(E,U,q,z,V,dt){N!==null&&V.isNodeMaterial&&N.setObject(E,V),E.onBeforeRender(T,U,q,z,V,dt),E.modelViewMatrix.multiplyMatrices(q.matrixWorldInverse,E.matrixWorld),E.normalMatrix.getNormalMatrix(E.modelViewMatrix),V.onBeforeRender(T,U,q,z,E,dt),V.transparent===!0&&V.side===hi&&V.forceSinglePass===!1?(V.side=un,V.needsUpdate=!0,T.renderBufferDirect(q,U,z,V,E,dt),V.side=ss,V.needsUpdate=!0,T.renderBufferDirect(q,U,z,V,E,dt),V.side=hi):T.renderBufferDirect(q,U,z,V,E,dt),E.onAfterRender(T,U,q,z,V,dt)}function Ad(E){let U=0;for(let q of E)q.texture!==null&&U++;return U}function qr(E,U,q){U.isScene!==!0&&(U=rn);let z=Lt.get(E),V=w.state.lights,dt=w.state.shadowsArray,Mt=V.state.version,ht=Q.getParameters(E,V.state,dt,U,q,w.state.lightProbeGridArray),yt=Q.getProgramCacheKey(ht),Et=z.programs;z.environment=E.isMeshStandardMaterial||E.isMeshLambertMaterial||E.isMeshPhongMaterial?U.environment:null,z.fog=U.fog;let Bt=E.isMeshStandardMaterial||E.isMeshLambertMaterial&&!E.envMap||E.isMeshPhongMaterial&&!E.envMap;z.envMap=R.get(E.envMap||z.environment,Bt),z.envMapRotation=z.environment!==null&&E.envMap===null?U.environmentRotation:E.envMapRotation,Et===void 0&&(E.addEventListener("dispose",le),Et=new Map,z.programs=Et,z.programVariants=new Map);let Zt=Et.get(yt);if(Zt!==void 0){if(z.currentProgram===Zt&&z.lightsStateVersion===Mt)return Td(E,ht),Zt}else ht.uniforms=Q.getUniforms(E),N!==null&&E.isNodeMaterial&&N.build(E,q,ht),E.onBeforeCompile(ht,T),Zt=Q.acquireProgram(ht,yt),Et.set(yt,Zt),z.uniforms=ht.uniforms;let St=z.uniforms;return(!E.isShaderMaterial&&!E.isRawShaderMaterial||E.clipping===!0)&&(St.clippingPlanes=J.uniform),Td(E,ht),z.needsLights=Xg(E),z.lightsStateVersion=Mt,z.needsLights&&(St.ambientLightColor.value=V.state.ambient,St.lightProbe.value=V.state.probe,St.sunLights.value=V.state.sun,St.sunLightShadows.value=V.state.sunShadow,St.directionalLights.value=V.state.directional,St.directionalLightShadows.value=V.state.directionalShadow,St.spotLights.value=V.state.spot,St.spotLightShadows.value=V.state.spotShadow,St.rectAreaLights.value=V.state.rectArea,St.ltc_1.value=V.state.rectAreaLTC1,St.ltc_2.value=V.state.rectAreaLTC2,St.pointLights.value=V.state.point,St.pointLightShadows.value=V.state.pointShadow,St.hemisphereLights.value=V.state.hemi,St.sunShadowMatrix.value=V.state.sunShadowMatrix,St.sunShadowCascade.value=V.state.sunShadowCascade,St.directionalShadowMatrix.value=V.state.directionalShadowMatrix,St.spotLightMatrix.value=V.state.spotLightMatrix,St.spotLightMap.value=V.state.spotLightMap,St.pointShadowMatrix.value=V.state.pointShadowMatrix),z.numLightProbeGrids=Ad(w.state.lightProbeGridArray),z.currentProgram=Zt,z.uniformsList=null,Zt}function Hg(E,U,q,z,V){let dt=Lt.get(E),Mt=dt.currentProgram.id+","+z+","+V,ht=dt.programVariants.get(Mt);return ht===void 0?(ht=qr(E,U,q),dt.programVariants.set(Mt,ht)):(dt.currentProgram=ht,dt.uniformsList=null,dt.outputColorSpace=z,dt.toneMapping=V),ht}function Ed(E){if(E.uniformsList===null){let U=E.currentProgram.getUniforms();E.uniformsList=Sr.seqWithValue(U.seq,E.uniforms)}return E.uniformsList}function Td(E,U){let q=Lt.get(E);q.outputColorSpace=U.outputColorSpace,q.batching=U.batching,q.batchingColor=U.batchingColor,q.instancing=U.instancing,q.instancingColor=U.instancingColor,q.instancingMorph=U.instancingMorph,q.skinning=U.skinning,q.morphTargets=U.morphTargets,q.morphNormals=U.morphNormals,q.morphColors=U.morphColors,q.morphTargetsCount=U.morphTargetsCount,q.numClippingPlanes=U.numClippingPlanes,q.numIntersection=U.numClipIntersection,q.vertexAlphas=U.vertexAlphas,q.vertexTangents=U.vertexTangents,q.toneMapping=U.toneMapping}function Wg(E,U,q,z,V){U.isScene!==!0&&(U=rn),Ft.resetTextureUnits();let dt=U.fog,Mt=z.isMeshStandardMaterial||z.isMeshLambertMaterial||z.isMeshPhongMaterial?U.environment:null,ht=j===null?T.outputColorSpace:j.isXRRenderTarget===!0?j.texture.colorSpace:Kt.workingColorSpace,yt=z.isMeshStandardMaterial||z.isMeshLambertMaterial&&!z.envMap||z.isMeshPhongMaterial&&!z.envMap,Et=R.get(z.envMap||Mt,yt),Bt=z.vertexColors===!0&&!!q.attributes.color&&q.attributes.color.itemSize===4,Zt=!!q.attributes.tangent&&(!!z.normalMap||z.anisotropy>0),St=!!q.morphAttributes.position,Jt=!!q.morphAttributes.normal,Le=!!q.morphAttributes.color,me=ui;z.toneMapped&&(j===null||j.isXRRenderTarget===!0)&&(me=T.toneMapping);let de=q.morphAttributes.position||q.morphAttributes.normal||q.morphAttributes.color,Qe=de!==void 0?de.length:0,bt=Lt.get(z),on=w.state.lights;if(xe===!0&&(ie===!0||E!==Y)){let Ae=E===Y&&z.id===W;J.setState(z,E,Ae)}let se=!1,As=!1;z.version===bt.__version?bt.needsLights&&bt.lightsStateVersion!==on.state.version||V.isBatchedMesh&&bt.batching===!1||!V.isBatchedMesh&&bt.batching===!0||V.isBatchedMesh&&bt.batchingColor===!0&&V._colorsTexture===null||V.isBatchedMesh&&bt.batchingColor===!1&&V._colorsTexture!==null||V.isInstancedMesh&&bt.instancing===!1||!V.isInstancedMesh&&bt.instancing===!0||V.isSkinnedMesh&&bt.skinning===!1||!V.isSkinnedMesh&&bt.skinning===!0||V.isInstancedMesh&&bt.instancingColor===!0&&V.instanceColor===null||V.isInstancedMesh&&bt.instancingColor===!1&&V.instanceColor!==null||V.isInstancedMesh&&bt.instancingMorph===!0&&V.morphTexture===null||V.isInstancedMesh&&bt.instancingMorph===!1&&V.morphTexture!==null||bt.envMap!==Et||z.fog===!0&&bt.fog!==dt||bt.numClippingPlanes!==void 0&&(bt.numClippingPlanes!==J.numPlanes||bt.numIntersection!==J.numIntersection)||bt.vertexAlphas!==Bt||bt.vertexTangents!==Zt||bt.morphTargets!==St||bt.morphNormals!==Jt||bt.morphColors!==Le||bt.morphTargetsCount!==Qe||bt.numLightProbeGrids!==Ad(w.state.lightProbeGridArray)?se=!0:(bt.outputColorSpace!==ht||bt.toneMapping!==me)&&(As=!0):(se=!0,bt.__version=z.version);let tn=bt.currentProgram;(se===!0||As===!0)&&(tn=As===!0?Hg(z,U,V,ht,me):qr(z,U,V),N&&z.isNodeMaterial&&N.onUpdateProgram(z,tn,bt));let la=!1,Wi=!1,Es=!1,Qt=tn.getUniforms(),Xe=bt.uniforms;if(mt.useProgram(tn.program)&&(la=!0,Wi=!0,Es=!0),z.id!==W&&(W=z.id,Wi=!0),la||Y!==E){mt.buffers.depth.getReversed()&&E.reversedDepth!==!0&&(E._reversedDepth=!0,E.updateProjectionMatrix()),Qt.setValue(O,"projectionMatrix",E.projectionMatrix),Qt.setValue(O,"viewMatrix",E.matrixWorldInverse);let Ge=Qt.map.cameraPosition;Ge!==void 0&&Ge.setValue(O,Mn.setFromMatrixPosition(E.matrixWorld)),Me.logarithmicDepthBuffer&&Qt.setValue(O,"logDepthBufFC",2/(Math.log(E.far+1)/Math.LN2)),(z.isMeshPhongMaterial||z.isMeshToonMaterial||z.isMeshLambertMaterial||z.isMeshBasicMaterial||z.isMeshStandardMaterial||z.isShaderMaterial)&&Qt.setValue(O,"isOrthographic",E.isOrthographicCamera===!0),Y!==E&&(Y=E,Wi=!0,Es=!0)}if(bt.needsLights&&(on.state.sunShadowMap.length>0&&Qt.setValue(O,"sunShadowMap",on.state.sunShadowMap,Ft),on.state.directionalShadowMap.length>0&&Qt.setValue(O,"directionalShadowMap",on.state.directionalShadowMap,Ft),on.state.spotShadowMap.length>0&&Qt.setValue(O,"spotShadowMap",on.state.spotShadowMap,Ft),on.state.pointShadowMap.length>0&&Qt.setValue(O,"pointShadowMap",on.state.pointShadowMap,Ft)),V.isSkinnedMesh){Qt.setOptional(O,V,"bindMatrix"),Qt.setOptional(O,V,"bindMatrixInverse");let Ae=V.skeleton;Ae&&(Ae.boneTexture===null&&Ae.computeBoneTexture(),Qt.setValue(O,"boneTexture",Ae.boneTexture,Ft))}V.isBatchedMesh&&(Qt.setOptional(O,V,"batchingTexture"),Qt.setValue(O,"batchingTexture",V._matricesTexture,Ft),Qt.setOptional(O,V,"batchingIdTexture"),Qt.setValue(O,"batchingIdTexture",V._indirectTexture,Ft),Qt.setOptional(O,V,"batchingColorTexture"),V._colorsTexture!==null&&Qt.setValue(O,"batchingColorTexture",V._colorsTexture,Ft));let Xn=q.morphAttributes;if((Xn.position!==void 0||Xn.normal!==void 0||Xn.color!==void 0)&&K.update(V,q,tn),(Wi||bt.receiveShadow!==V.receiveShadow)&&(bt.receiveShadow=V.receiveShadow,Qt.setValue(O,"receiveShadow",V.receiveShadow)),(z.isMeshStandardMaterial||z.isMeshLambertMaterial||z.isMeshPhongMaterial)&&z.envMap===null&&U.environment!==null&&(Xe.envMapIntensity.value=U.environmentIntensity),Xe.dfgLUT!==void 0&&(Xe.dfgLUT.value=OM()),Wi){if(Qt.setValue(O,"toneMappingExposure",T.toneMappingExposure),bt.needsLights&&qg(Xe,Es),dt&&z.fog===!0&&ot.refreshFogUniforms(Xe,dt),ot.refreshMaterialUniforms(Xe,z,pt,At,w.state.transmissionRenderTarget[E.id]),bt.needsLights&&bt.numLightProbeGrids>0){let Ae=v,Ge=0;for(let Mi of w.state.lightProbeGridArray)Mi.texture!==null&&(Ae.textures[Ge]=Mi.texture,Ae.min[Ge]=Mi.boundingBox.min,Ae.max[Ge]=Mi.boundingBox.max,Ae.resolution[Ge]=Mi.resolution,Ge++);for(let Mi in Ae)Ae[Mi].length=Ge;Xe.probesSH.value=Ae.textures,Xe.probesMin.value=Ae.min,Xe.probesMax.value=Ae.max,Xe.probesResolution.value=Ae.resolution}Sr.upload(O,Ed(bt),Xe,Ft)}if(z.isShaderMaterial&&z.uniformsNeedUpdate===!0&&(Sr.upload(O,Ed(bt),Xe,Ft),z.uniformsNeedUpdate=!1),z.isSpriteMaterial&&Qt.setValue(O,"center",V.center),Qt.setValue(O,"modelViewMatrix",V.modelViewMatrix),Qt.setValue(O,"normalMatrix",V.normalMatrix),Qt.setValue(O,"modelMatrix",V.matrixWorld),z.uniformsGroups!==void 0){let Ae=z.uniformsGroups;for(let Ge=0,Mi=Ae.length;Ge<Mi;Ge++){let Cd=Ae[Ge];Ct.update(Cd,tn),Ct.bind(Cd,tn)}}return tn}function qg(E,U){E.ambientLightColor.needsUpdate=U,E.lightProbe.needsUpdate=U,E.sunLights.needsUpdate=U,E.sunLightShadows.needsUpdate=U,E.directionalLights.needsUpdate=U,E.directionalLightShadows.needsUpdate=U,E.pointLights.needsUpdate=U,E.pointLightShadows.needsUpdate=U,E.spotLights.needsUpdate=U,E.spotLightShadows.needsUpdate=U,E.rectAreaLights.needsUpdate=U,E.hemisphereLights.needsUpdate=U}function Xg(E){return E.isMeshLambertMaterial||E.isMeshToonMaterial||E.isMeshPhongMaterial||E.isMeshStandardMaterial||E.isShadowMaterial||E.isShaderMaterial&&E.lights===!0}this.getActiveCubeFace=function(){return G},this.getActiveMipmapLevel=function(){return H},this.getRenderTarget=function(){return j},this.setRenderTargetTextures=function(E,U,q){let z=Lt.get(E);z.__autoAllocateDepthBuffer=E.resolveDepthBuffer===!1,z.__autoAllocateDepthBuffer===!1&&(z.__useRenderToTexture=!1),Lt.get(E.texture).__webglTexture=U,Lt.get(E.depthTexture).__webglTexture=z.__autoAllocateDepthBuffer?void 0:q,z.__hasExternalTextures=!0},this.setRenderTargetFramebuffer=function(E,U){let q=Lt.get(E);q.__webglFramebuffer=U,q.__useDefaultFramebuffer=U===void 0},this.setRenderTarget=function(E,U=0,q=0){j=E,G=U,H=q;let z=null,V=!1,dt=!1;if(E){let ht=Lt.get(E);if(ht.__useDefaultFramebuffer!==void 0){mt.bindFramebuffer(O.FRAMEBUFFER,ht.__webglFramebuffer),tt.copy(E.viewport),gt.copy(E.scissor),wt=E.scissorTest,mt.viewport(tt),mt.scissor(gt),mt.setScissorTest(wt),W=-1;return}else if(ht.__webglFramebuffer===void 0)Ft.setupRenderTarget(E);else if(ht.__hasExternalTextures)Ft.rebindTextures(E,Lt.get(E.texture).__webglTexture,Lt.get(E.depthTexture).__webglTexture);else if(E.depthBuffer){let Bt=E.depthTexture;if(ht.__boundDepthTexture!==Bt){if(Bt!==null&&Lt.has(Bt)&&(E.width!==Bt.image.width||E.height!==Bt.image.height))throw new Error("THREE.WebGLRenderer: Attached DepthTexture is initialized to the incorrect size.");Ft.setupDepthRenderbuffer(E)}}let yt=E.texture;(yt.isData3DTexture||yt.isDataArrayTexture||yt.isCompressedArrayTexture)&&(dt=!0);let Et=Lt.get(E).__webglFramebuffer;E.isWebGLCubeRenderTarget?(Array.isArray(Et[U])?z=Et[U][q]:z=Et[U],V=!0):E.samples>0&&Ft.useMultisampledRTT(E)===!1?z=Lt.get(E).__webglMultisampledFramebuffer:Array.isArray(Et)?z=Et[q]:z=Et,tt.copy(E.viewport),gt.copy(E.scissor),wt=E.scissorTest}else tt.copy(Rt).multiplyScalar(pt).floor(),gt.copy(Yt).multiplyScalar(pt).floor(),wt=jt;if(q!==0&&(z=F),mt.bindFramebuffer(O.FRAMEBUFFER,z)&&mt.drawBuffers(E,z),mt.viewport(tt),mt.scissor(gt),mt.setScissorTest(wt),V){let ht=Lt.get(E.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_CUBE_MAP_POSITIVE_X+U,ht.__webglTexture,q)}else if(dt){let ht=U;for(let yt=0;yt<E.textures.length;yt++){let Et=Lt.get(E.textures[yt]);O.framebufferTextureLayer(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0+yt,Et.__webglTexture,q,ht)}}else if(E!==null&&q!==0){let ht=Lt.get(E.texture);O.framebufferTexture2D(O.FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,ht.__webglTexture,q)}W=-1};function Rd(E){let U=Lt.get(E);return(U.__readFormat!==E.format||U.__readType!==E.type)&&(U.__readFormat=E.format,U.__readType=E.type,U.__formatReadable=Me.textureFormatReadable(E.format),U.__typeReadable=Me.textureTypeReadable(E.type)),U}this.readRenderTargetPixels=function(E,U,q,z,V,dt,Mt,ht=0){if(!(E&&E.isWebGLRenderTarget)){Ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");return}let yt=Lt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Mt!==void 0&&(yt=yt[Mt],Array.isArray(yt)&&(yt=yt[0])),yt){mt.bindFramebuffer(O.FRAMEBUFFER,yt);try{let Et=E.textures[ht],Bt=Et.format,Zt=Et.type;E.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ht);let St=Rd(Et);if(St.__formatReadable===!1){Ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in RGBA or implementation defined format.");return}if(St.__typeReadable===!1){Ut("WebGLRenderer.readRenderTargetPixels: renderTarget is not in UnsignedByteType or implementation defined type.");return}U>=0&&U<=E.width-z&&q>=0&&q<=E.height-V&&O.readPixels(U,q,z,V,it.convert(Bt),it.convert(Zt),dt)}finally{let Et=j!==null?Lt.get(j).__webglFramebuffer:null;mt.bindFramebuffer(O.FRAMEBUFFER,Et)}}},this.readRenderTargetPixelsAsync=async function(E,U,q,z,V,dt,Mt,ht=0){if(!(E&&E.isWebGLRenderTarget))throw new Error("THREE.WebGLRenderer.readRenderTargetPixels: renderTarget is not THREE.WebGLRenderTarget.");let yt=Lt.get(E).__webglFramebuffer;if(E.isWebGLCubeRenderTarget&&Mt!==void 0&&(yt=yt[Mt],Array.isArray(yt)&&(yt=yt[0])),yt)if(U>=0&&U<=E.width-z&&q>=0&&q<=E.height-V){mt.bindFramebuffer(O.FRAMEBUFFER,yt);let Et=E.textures[ht],Bt=Et.format,Zt=Et.type;E.textures.length>1&&O.readBuffer(O.COLOR_ATTACHMENT0+ht);let St=Rd(Et);if(St.__formatReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in RGBA or implementation defined format.");if(St.__typeReadable===!1)throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: renderTarget is not in UnsignedByteType or implementation defined type.");let Jt=O.createBuffer();O.bindBuffer(O.PIXEL_PACK_BUFFER,Jt),O.bufferData(O.PIXEL_PACK_BUFFER,dt.byteLength,O.STREAM_READ),O.readPixels(U,q,z,V,it.convert(Bt),it.convert(Zt),0),O.bindBuffer(O.PIXEL_PACK_BUFFER,null);let Le=j!==null?Lt.get(j).__webglFramebuffer:null;mt.bindFramebuffer(O.FRAMEBUFFER,Le);let me=O.fenceSync(O.SYNC_GPU_COMMANDS_COMPLETE,0);return O.flush(),await $f(O,me,4),O.bindBuffer(O.PIXEL_PACK_BUFFER,Jt),O.getBufferSubData(O.PIXEL_PACK_BUFFER,0,dt),O.bindBuffer(O.PIXEL_PACK_BUFFER,null),O.deleteBuffer(Jt),O.deleteSync(me),dt}else throw new Error("THREE.WebGLRenderer.readRenderTargetPixelsAsync: requested read bounds are out of range.")},this.copyFramebufferToTexture=function(E,U=null,q=0){let z=Math.pow(2,-q),V=Math.floor(E.image.width*z),dt=Math.floor(E.image.height*z),Mt=U!==null?U.x:0,ht=U!==null?U.y:0;Ft.setTexture2D(E,0),O.copyTexSubImage2D(O.TEXTURE_2D,q,0,0,Mt,ht,V,dt),mt.unbindTexture()},this.copyTextureToTexture=function(E,U,q=null,z=null,V=0,dt=0){let Mt,ht,yt,Et,Bt,Zt,St,Jt,Le,me=E.isCompressedTexture?E.mipmaps[dt]:E.image;if(q!==null)Mt=q.max.x-q.min.x,ht=q.max.y-q.min.y,yt=q.isBox3?q.max.z-q.min.z:1,Et=q.min.x,Bt=q.min.y,Zt=q.isBox3?q.min.z:0;else{let Qt=Math.pow(2,-V);Mt=Math.floor(me.width*Qt),ht=Math.floor(me.height*Qt),E.isDataArrayTexture?yt=me.depth:E.isData3DTexture?yt=Math.floor(me.depth*Qt):yt=1,Et=0,Bt=0,Zt=0}z!==null?(St=z.x,Jt=z.y,Le=z.z):(St=0,Jt=0,Le=0);let de=it.convert(U.format),Qe=it.convert(U.type),bt;U.isData3DTexture?(Ft.setTexture3D(U,0),bt=O.TEXTURE_3D):U.isDataArrayTexture||U.isCompressedArrayTexture?(Ft.setTexture2DArray(U,0),bt=O.TEXTURE_2D_ARRAY):(Ft.setTexture2D(U,0),bt=O.TEXTURE_2D),mt.activeTexture(O.TEXTURE0),mt.pixelStorei(O.UNPACK_FLIP_Y_WEBGL,U.flipY),mt.pixelStorei(O.UNPACK_PREMULTIPLY_ALPHA_WEBGL,U.premultiplyAlpha),mt.pixelStorei(O.UNPACK_ALIGNMENT,U.unpackAlignment);let on=mt.getParameter(O.UNPACK_ROW_LENGTH),se=mt.getParameter(O.UNPACK_IMAGE_HEIGHT),As=mt.getParameter(O.UNPACK_SKIP_PIXELS),tn=mt.getParameter(O.UNPACK_SKIP_ROWS),la=mt.getParameter(O.UNPACK_SKIP_IMAGES);mt.pixelStorei(O.UNPACK_ROW_LENGTH,me.width),mt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,me.height),mt.pixelStorei(O.UNPACK_SKIP_PIXELS,Et),mt.pixelStorei(O.UNPACK_SKIP_ROWS,Bt),mt.pixelStorei(O.UNPACK_SKIP_IMAGES,Zt);let Wi=E.isDataArrayTexture||E.isData3DTexture,Es=U.isDataArrayTexture||U.isData3DTexture;if(E.isDepthTexture){let Qt=Lt.get(E),Xe=Lt.get(U),Xn=Lt.get(Qt.__renderTarget),Ae=Lt.get(Xe.__renderTarget);mt.bindFramebuffer(O.READ_FRAMEBUFFER,Xn.__webglFramebuffer),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,Ae.__webglFramebuffer);for(let Ge=0;Ge<yt;Ge++)Wi&&(O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Lt.get(E).__webglTexture,V,Zt+Ge),O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Lt.get(U).__webglTexture,dt,Le+Ge)),O.blitFramebuffer(Et,Bt,Et+Mt,Bt+ht,St,Jt,St+Mt,Jt+ht,O.DEPTH_BUFFER_BIT,O.NEAREST);mt.bindFramebuffer(O.READ_FRAMEBUFFER,null),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else if(V!==0||E.isRenderTargetTexture||Lt.has(E)){let Qt=Lt.get(E),Xe=Lt.get(U);mt.bindFramebuffer(O.READ_FRAMEBUFFER,P),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,B);for(let Xn=0;Xn<yt;Xn++)Wi?O.framebufferTextureLayer(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Qt.__webglTexture,V,Zt+Xn):O.framebufferTexture2D(O.READ_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Qt.__webglTexture,V),Es?O.framebufferTextureLayer(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,Xe.__webglTexture,dt,Le+Xn):O.framebufferTexture2D(O.DRAW_FRAMEBUFFER,O.COLOR_ATTACHMENT0,O.TEXTURE_2D,Xe.__webglTexture,dt),V!==0?O.blitFramebuffer(Et,Bt,Et+Mt,Bt+ht,St,Jt,St+Mt,Jt+ht,O.COLOR_BUFFER_BIT,O.NEAREST):Es?O.copyTexSubImage3D(bt,dt,St,Jt,Le+Xn,Et,Bt,Mt,ht):O.copyTexSubImage2D(bt,dt,St,Jt,Et,Bt,Mt,ht);mt.bindFramebuffer(O.READ_FRAMEBUFFER,null),mt.bindFramebuffer(O.DRAW_FRAMEBUFFER,null)}else Es?E.isDataTexture||E.isData3DTexture?O.texSubImage3D(bt,dt,St,Jt,Le,Mt,ht,yt,de,Qe,me.data):U.isCompressedArrayTexture?O.compressedTexSubImage3D(bt,dt,St,Jt,Le,Mt,ht,yt,de,me.data):O.texSubImage3D(bt,dt,St,Jt,Le,Mt,ht,yt,de,Qe,me):E.isDataTexture?O.texSubImage2D(O.TEXTURE_2D,dt,St,Jt,Mt,ht,de,Qe,me.data):E.isCompressedTexture?O.compressedTexSubImage2D(O.TEXTURE_2D,dt,St,Jt,me.width,me.height,de,me.data):O.texSubImage2D(O.TEXTURE_2D,dt,St,Jt,Mt,ht,de,Qe,me);mt.pixelStorei(O.UNPACK_ROW_LENGTH,on),mt.pixelStorei(O.UNPACK_IMAGE_HEIGHT,se),mt.pixelStorei(O.UNPACK_SKIP_PIXELS,As),mt.pixelStorei(O.UNPACK_SKIP_ROWS,tn),mt.pixelStorei(O.UNPACK_SKIP_IMAGES,la),dt===0&&U.generateMipmaps===!0&&U.mipmapsAutoUpdate===!0&&O.generateMipmap(bt),mt.unbindTexture()},this.initRenderTarget=function(E){Lt.get(E).__webglFramebuffer===void 0&&Ft.setupRenderTarget(E)},this.initTexture=function(E){E.isCubeTexture?Ft.setTextureCube(E,0):E.isData3DTexture?Ft.setTexture3D(E,0):E.isDataArrayTexture||E.isCompressedArrayTexture?Ft.setTexture2DArray(E,0):Ft.setTexture2D(E,0),mt.unbindTexture()},this.resetState=function(){G=0,H=0,j=null,mt.reset(),at.reset()},typeof __THREE_DEVTOOLS__<"u"&&__THREE_DEVTOOLS__.dispatchEvent(new CustomEvent("observe",{detail:this}))}get coordinateSystem(){return Bn}get outputColorSpace(){return this._outputColorSpace}set outputColorSpace(t){this._outputColorSpace=t;let e=this.getContext();e.drawingBufferColorSpace=Kt._getDrawingBufferColorSpace(t),e.unpackColorSpace=Kt._getUnpackColorSpace()}};var _l=26,gl=.1,Pp=1.55,[FM,BM]=[.4,6],zM=5,xl=class{constructor(t){this.azimuth=.52,this.elevation=.38,this.zoom=1,this.onChange=t,this.taken=null,document.addEventListener("pointerdown",e=>e.target!==this.taken&&this.letGo(),{capture:!0}),document.addEventListener("keydown",e=>e.key==="Escape"&&this.letGo())}take(t){this.letGo(),this.taken=t,t.parentElement.classList.add("held")}letGo(){this.taken?.parentElement?.classList.remove("held"),this.taken=null}turn(t,e){this.azimuth-=t,this.elevation=Math.min(Pp,Math.max(-Pp,this.elevation+e)),this.onChange()}closer(t){this.zoom=Math.min(BM,Math.max(FM,this.zoom*t)),this.onChange()}place(t,e,n,s){let r=_l*Math.PI/360,o=Math.min(r,Math.atan(Math.tan(r)*s)),a=n/Math.sin(o)/this.zoom,[c,l]=[Math.cos(this.elevation),Math.sin(this.elevation)];t.position.set(c*Math.cos(this.azimuth),c*Math.sin(this.azimuth),l).multiplyScalar(a).add(e),t.up.set(0,0,1),t.aspect=s,t.near=Math.max(a-4*n,a/100),t.far=a+8*n,t.lookAt(e),t.updateProjectionMatrix(),t.updateMatrixWorld()}listen(t){let e=new Map,n=null,s=()=>{let[r,o]=[...e.values()];return Math.hypot(r[0]-o[0],r[1]-o[1])};t.addEventListener("pointerdown",r=>{r.button===0&&(n=[r.clientX,r.clientY],e.set(r.pointerId,n),t.setPointerCapture(r.pointerId))}),t.addEventListener("mousedown",r=>r.preventDefault()),t.addEventListener("pointermove",r=>{let o=e.get(r.pointerId);if(!o)return;let a=e.size===2?s():0;e.set(r.pointerId,[r.clientX,r.clientY]),e.size===2?this.closer(s()/Math.max(a,1)):e.size===1&&this.turn((r.clientX-o[0])*.008,(r.clientY-o[1])*.008)});for(let r of["pointerup","pointercancel"])t.addEventListener(r,o=>e.delete(o.pointerId));t.addEventListener("pointerup",r=>{n&&Math.hypot(r.clientX-n[0],r.clientY-n[1])<zM&&r.pointerType==="mouse"&&this.take(t),n=null}),t.addEventListener("wheel",r=>this.wheel(r,t),{passive:!1})}wheel(t,e){this.taken!==e&&!t.ctrlKey||(t.preventDefault(),this.closer(Math.exp(-.002*(t.deltaY||t.deltaX))))}key(t){let e={ArrowLeft:[gl,0],ArrowRight:[-gl,0],ArrowUp:[0,gl],ArrowDown:[0,-gl]};if(e[t])this.turn(...e[t]);else if(t==="PageUp")this.closer(1.15);else if(t==="PageDown")this.closer(1/1.15);else return!1;return!0}},Ip=()=>new cn(_l,1,.1,100),Pu=new I(0,0,0);var yl=i=>document.getElementById(i);function Iu({name:i,title:t=i,summary:e,notes:n}){yl("name").textContent=t,yl("summary").textContent=e,yl("notes").replaceChildren(...n.map(s=>Bs("li",s)))}function Bs(i,t,e=""){let n=document.createElement(i);return n.textContent=t,e&&(n.className=e),n}function Lp(i,t){let e=document.createElement("figure");e.className=i.flat?"panel flat":"panel";let n=document.createElement("canvas");n.setAttribute("role","img"),i.flat||(n.tabIndex=0,t.listen(n),n.addEventListener("keydown",r=>{t.key(r.key)&&r.preventDefault()}));let s=document.createElement("button");return s.type="button",s.className="enlarge",e.append(n,document.createElement("figcaption"),s),yl("panels").append(e),n}function Np(i,t,e){let n=i.nextElementSibling,s=t.title==="The body in space"&&e.up==="L"?"L points up":"",r=Bs("span",[t.words,s].filter(Boolean).join("; "),"words"),o=Bs("span","","legend");for(let{color:l,text:h}of t.legend){let[u,d]=[document.createElement("span"),document.createElement("i")];d.style.background=l,u.append(d,h),o.append(u)}let a=Bs("span","","heading");a.append(Bs("strong",t.title),r),n.replaceChildren(a,o),n.nextElementSibling.setAttribute("aria-label",`Make large: ${t.title}`);let c=t.flat?".":". Arrow keys turn the view, page up and down bring it closer.";i.setAttribute("aria-label",[t.title,t.words].filter(Boolean).join(": ")+c)}function Dp(i,t){i.replaceChildren(...t.map(([e,n])=>{let s=document.createElement("div");return s.append(Bs("dt",e),Bs("dd",n)),s}))}var vl=class{constructor(t,e,n){this.roots=t,this.onChange=e,this.refuse=n,this.rows=new Map}show(t,e){let n=t.map(({key:s})=>s);if(n.join()!==this.keys){this.keys=n.join();let s=new Map(t.map(a=>[a.key,this.rows.get(a.key)??this.row(a)]));this.rows=s;let r=e.filter(a=>s.has(a)),o=n.filter(a=>!r.includes(a));Up(this.roots.first,r.map(a=>s.get(a).line)),Up(this.roots.more,o.map(a=>s.get(a).line)),this.roots.fold.hidden=!o.length}for(let s of t)this.refresh(s)}row(t){let e=document.createElement("div");e.className=t.choices?"control choice":"control";let n=document.createElement("label"),s=`set-${t.key.replaceAll(".","-")}`;n.htmlFor=s,e.append(n);let r={label:n,line:e};if(t.choices){r.choice=document.createElement("select"),r.choice.id=s;for(let[o,a]of t.choices)r.choice.append(new Option(a,o));r.choice.addEventListener("change",()=>this.onChange(t.key,Number(r.choice.value))),e.append(r.choice)}else r.slider=document.createElement("input"),Object.assign(r.slider,{type:"range",min:0,max:1e3,step:"any"}),r.slider.addEventListener("input",()=>this.onChange(t.key,kM(r.control,Number(r.slider.value)/1e3))),r.slider.addEventListener("change",()=>this.settle()),r.field=document.createElement("input"),Object.assign(r.field,{type:"text",inputMode:"decimal",id:s,autocomplete:"off"}),r.field.addEventListener("change",()=>this.typed(r)),r.unit=document.createElement("span"),e.append(r.field,r.unit,r.slider);return r}refresh(t){let e=this.rows.get(t.key);if(e.label.textContent=t.label,e.choice){e.choice.value=String(t.value);return}let n=e.slider===document.activeElement&&e.slider.matches(":active");e.control=n?{...e.control,value:t.value}:t,e.slider.setAttribute("aria-label",t.label),n||(e.slider.value=String(1e3*GM(t,t.value))),e.slider.style.setProperty("--part",`${100*Number(e.slider.value)/1e3}%`);let s=Lu(t.value/(t.si??1));e.slider.setAttribute("aria-valuetext",`${s} ${t.unit}`),document.activeElement!==e.field&&(e.field.value=s),e.unit.textContent=t.unit,e.field.setAttribute("aria-label",`${t.label} [${t.unit}]`),e.field.setCustomValidity(""),e.field.removeAttribute("aria-invalid")}settle(){this.onChange(null)}typed(t){let e=Number(t.field.value.trim().replace(",","."))*(t.control.si??1),{low:n,high:s,log:r,unit:o,si:a=1}=t.control,c=!t.field.value.trim()||!Number.isFinite(e)?"A number is needed.":r&&!(e>0)?"It must be greater than zero.":"",l=t.control.key.startsWith("body.moments")&&(e<n*.999||e>s*1.001),h=c||(l?`No body has this moment with the two others: ${Lu(n/a)} to ${Lu(s/a)} ${o}.`:"");t.field.setCustomValidity(h),h?(t.field.setAttribute("aria-invalid","true"),t.field.reportValidity(),this.refuse(h)):this.onChange(t.control.key,e)}};function Up(i,t){for(let e of[...i.children])t.includes(e)||e.remove();t.forEach((e,n)=>i.children[n]!==e&&i.insertBefore(e,i.children[n]??null))}function kM({low:i,high:t,log:e,power:n=1},s){return e?i*(t/i)**s:i+(t-i)*s**n}function GM({low:i,high:t,log:e,power:n=1},s){let r=e?Math.log(Math.max(s,Number.MIN_VALUE)/i)/Math.log(t/i):((s-i)/(t-i))**(1/n);return Math.min(1,Math.max(0,Number.isFinite(r)?r:0))}function Lu(i){if(i===0)return"0";let t=Math.abs(i);return t>=.001&&t<1e6?String(Number(i.toPrecision(7))):i.toExponential(5)}var Wu={};qi(Wu,{asSpec:()=>JS,changed:()=>YS,controls:()=>$S,event:()=>tb,facts:()=>QS,first:()=>WS,from:()=>XS,keys:()=>qS,make:()=>ZS,toml:()=>jS,withSpec:()=>KS});var yn=[Math.PI,12246467991473532e-32],Go=[.15915494309189535,-9839338337591243e-33],Fp=[.6931471805599453,23190468138462996e-33],fn=[0,0],Pe=[1,0],VM=134217729;function Fi(i){let t=VM*i;return t-(t-i)}function ze(i,t){let e=i+t,n=e-i;return[e,i-(e-n)+(t-n)]}function Bi(i,t){let e=i+t;return[e,t-(e-i)]}function Te(i,t){let e=Fi(i),n=i-e,s=Fi(t),r=t-s,o=i*t;return[o,e*s-o+e*r+n*s+n*r]}var We=i=>[i,0],fi=i=>[-i[0],-i[1]];function Tt(i,t){let[e,n]=ze(i[0],t[0]);return Bi(e,n+(i[1]+t[1]))}var ne=(i,t)=>Tt(i,fi(t));function st(i,t){let[e,n]=Te(i[0],t[0]);return Bi(e,n+(i[0]*t[1]+i[1]*t[0]))}var Vn=(i,t)=>st(i,[t,0]),Hn=i=>st(i,i),vt=(i,t)=>[i[0]*t,i[1]*t];function Nt(i,t){let e=i[0]/t[0],[n,s]=Te(e,t[0]),r=i[0]-n-s+(i[1]-e*t[1]);return Bi(e,r/t[0])}function Re(i){let t=Math.sqrt(i[0]),[e,n]=Te(t,t),s=i[0]-e-n+i[1];return Bi(t,s/(t>0?t+t:1))}var Ml=(i,t)=>i.flatMap(e=>Te(e,t)),Bp=(i,t)=>t.flatMap(e=>Ml(i,e));function zp(i){let t=[],e=i[0];for(let n=1;n<i.length;n++){let[s,r]=ze(e,i[n]);e=s,t.push(r)}return t.push(e),t}function wr(i,t=5){let e=i;for(let s=0;s<t;s++)e=zp(e);let n=e[0];for(let s=1;s<e.length-1;s++)n+=e[s];return ze(e[e.length-1],n)}function Sl(i,t=4){if(i.length<=t)return i;let e=i;for(let n=0;n<=t;n++)e=zp(e);return e.slice(-t)}var Op=new DataView(new ArrayBuffer(8));function Ye(i){if(i===0)return 0;Op.setFloat64(0,i);let t=Op.getUint32(0)>>>20&2047;return t===0?Ye(i*2**100)-100:t-1022}function he(i,t){let e=Math.max(-1e3,Math.min(1e3,t)),n=i*2**e;return t===e?n:he(n,t-e)}var HM=1e-6,kp=1e27,bl=i=>{let t=String(JSON.stringify(i,(e,n)=>typeof n=="number"&&!Number.isFinite(n)?String(n):n));return t.length>80?`${t.slice(0,77)}...`:t};function Se(i,t,e){if(typeof t=="number"&&Number.isFinite(t))return t;throw new RangeError(`\`${i}\` must be a finite number; got ${bl(t)}. Give it in ${e}.`)}function pn(i,t,e,n){let s=t!=null&&typeof t=="object"?Array.from(t):[];if(s.length===e&&s.every(r=>typeof r=="number"&&Number.isFinite(r)))return s;throw new RangeError(`\`${i}\` must be ${e} finite numbers; got ${bl(t)}. Give them in ${n}.`)}function Ar(i){let t=pn("moments",i,3,"kg m\xB2");if(t.every(e=>e>0))return t;throw new RangeError(`\`moments\` must be positive; got ${bl(t)} kg m\xB2. A body with a zero moment (a thin rod) cannot spin about that axis; check values and units.`)}function Er(i){let t=pn("attitude",i,4,"w, x, y, z");if(Math.abs(Math.hypot(...t)-1)<HM)return t;throw new RangeError(`\`attitude\` must be a unit quaternion w, x, y, z; got ${bl(t)}. Divide it by its norm, and check that the scalar comes first.`)}function wl(i,t,e){Se("t",i,"seconds");let n=ze(i,-t);if(Math.abs(n[0])*e<=kp)return n;throw new RangeError(`\`t\` less the epoch, times the rate of rotation, must be at most ${kp} rad, beyond which a phase has hardly a digit left; got ${i} s. Check times and rates.`)}function Al(i){if(!i.every(Number.isFinite))throw new RangeError("moments, momentum or their ratios leave the range of doubles: choose other units.")}function Nu([i,t,e,n],[s,r,o,a]){return[i*s-t*r-e*o-n*a,i*r+t*s+e*a-n*o,i*o-t*a+e*s+n*r,i*a+t*o-e*r+n*s]}var WM=([i,t,e,n])=>[i,-t,-e,-n],qM=([i,t,e,n])=>Math.sqrt(i*i+t*t+e*e+n*n);function Tr(i){let t=qM(i);return i.map(e=>e/t)}function Vo([i,t,e,n],[s,r,o]){let a=2*(e*o-n*r),c=2*(n*s-t*o),l=2*(t*r-e*s);return[s+i*a+(e*l-n*c),r+i*c+(n*a-t*l),o+i*l+(t*c-e*a)]}var as=(i,t)=>Vo(WM(i),t);var $M=[0,.05260015195876773,.0789002279381516,.1183503419072274,.2816496580927726,.3333333333333333,.25,.3076923076923077,.6512820512820513,.6,.8571428571428571,1],Gp=[[],[[0,.05260015195876773]],[[0,.0197250569845379],[1,.0591751709536137]],[[0,.02958758547680685],[2,.08876275643042054]],[[0,.2413651341592667],[2,-.8845494793282861],[3,.924834003261792]],[[0,.037037037037037035],[3,.17082860872947386],[4,.12546768756682242]],[[0,.037109375],[3,.17025221101954405],[4,.06021653898045596],[5,-.017578125]],[[0,.03709200011850479],[3,.17038392571223998],[4,.10726203044637328],[5,-.015319437748624402],[6,.008273789163814023]],[[0,.6241109587160757],[3,-3.3608926294469414],[4,-.868219346841726],[5,27.59209969944671],[6,20.154067550477894],[7,-43.48988418106996]],[[0,.47766253643826434],[3,-2.4881146199716677],[4,-.590290826836843],[5,21.230051448181193],[6,15.279233632882423],[7,-33.28821096898486],[8,-.020331201708508627]],[[0,-.9371424300859873],[3,5.186372428844064],[4,1.0914373489967295],[5,-8.149787010746927],[6,-18.52006565999696],[7,22.739487099350505],[8,2.4936055526796523],[9,-3.0467644718982196]],[[0,2.273310147516538],[3,-10.53449546673725],[4,-2.0008720582248625],[5,-17.9589318631188],[6,27.94888452941996],[7,-2.8589982771350235],[8,-8.87285693353063],[9,12.360567175794303],[10,.6433927460157636]]],YM=[[0,.054293734116568765],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,.3111643669578199],[9,-.1521609496625161],[10,.20136540080403034],[11,.04471061572777259]],ZM=[[0,.01312004499419488],[5,-1.2251564463762044],[6,-.4957589496572502],[7,1.6643771824549864],[8,-.35032884874997366],[9,.3341791187130175],[10,.08192320648511571],[11,-.022355307863886294]],JM=[[0,-.18980075407240762],[5,4.450312892752409],[6,1.8915178993145003],[7,-5.801203960010585],[8,-.4226823213237919],[9,-.1521609496625161],[10,.20136540080403034],[11,.02265179219836082]],KM=.01,El=class{constructor(t,e){this.rates=t,this.size=e,this.stages=Gp.map(()=>new Float64Array(e)),this.inner=new Float64Array(e)}step(t,e,n,s,r=!1){let{rates:o,size:a,stages:c,inner:l}=this;r||o(t,e,c[0]);for(let h=1;h<c.length;h++)Vp(Gp[h],c,e,n,l,a),o(t+$M[h]*n,l,c[h]);Vp(YM,c,e,n,s,a)}error(t,e,n,s,r){let{size:o,stages:a}=this,[c,l]=[0,0];for(let h=0;h<o;h++){let u=r*(s[h]+Math.max(Math.abs(e[h]),Math.abs(n[h])));c+=(Du(ZM,a,h)/u)**2,l+=(Du(JM,a,h)/u)**2}return c===0&&l===0?0:Math.abs(t)*c/Math.sqrt((c+KM*l)*o)}};function Du(i,t,e){let n=0;for(let s=0;s<i.length;s++)n+=i[s][1]*t[i[s][0]][e];return n}function Vp(i,t,e,n,s,r){for(let o=0;o<r;o++)s[o]=e[o]+n*Du(i,t,o)}var jM=1e-12,QM=2e5,tS=2048,eS=16,[Hp,Uu,nS]=[.9,.2,8],Wp=-1/8,iS=16*Number.EPSILON,sS=60,ni=class{constructor({rates:t,start:e,time:n=0,scale:s,tolerance:r=jM,project:o,stops:a={},mostSteps:c=QM}){Object.assign(this,{time:n,tolerance:r,mostSteps:c}),this.scale=Float64Array.from(s),this.project=o??(()=>{}),this.stops=Object.entries(a),this._method=new El((l,h,u)=>t(n+l,h,u),e.length),this._rates=t,this._begun=null,this._forward=this._chain(1,e),this._backward=this._chain(-1,e)}at(t){let e=t-this.time,n=e<0?this._backward:this._forward,s=this._before(n,Math.abs(e)),r=s.state.slice();return s===n.end||s.elapsed===e||this._step(s,e-s.elapsed,r),r}end(t=!0){let{end:e}=t?this._forward:this._backward;return e&&{time:this.time+e.elapsed,event:e.event}}_chain(t,e){let n=Float64Array.from(e),s={elapsed:0,state:n,step:t*this._firstStep(n),count:0};return{sense:t,kept:[s],spacing:eS,from:s,to:null,end:null}}_before(t,e){let{end:n}=t;if(n&&e>=Math.abs(n.elapsed))return n;let s=rS(t.kept,e);(e<Math.abs(t.from.elapsed)||s.count>t.from.count)&&([t.from,t.to]=[s,null]);for(let r=0;;r++){if(t.to??=this._advance(t,t.from),Math.abs(t.to.elapsed)>e)return t.from;if(t.to===t.end)return t.end;r>=this.mostSteps&&this._tooFar(t,e),[t.from,t.to]=[t.to,null],oS(t,t.from)}}_advance(t,e){let n=new Float64Array(e.state.length),s=e.step,r=nS;for(;;){(!(Math.abs(s)>iS*Math.abs(e.elapsed))||s===0)&&this._stuck(e),this._step(e,s,n);let o=this._method.error(s,e.state,n,this.scale,this.tolerance);if(o<=1){let a=o===0?r:Math.min(r,Math.max(Uu,Hp*o**Wp)),c={elapsed:e.elapsed+s,state:n,step:s*a,count:e.count+1};return this._ended(t,e,c)??c}s*=o>1?Math.max(Uu,Hp*o**Wp):Uu,r=1}}_step(t,e,n){this._method.step(t.elapsed,t.state,e,n,this._begun===t),this._begun=t,this.project(n)}_ended(t,e,n){let s=(l,h)=>this.stops.find(([,u])=>!(u(this.time+l,h)>0)),r=s(n.elapsed,n.state);if(!r)return null;let o=n.state.slice(),[a,c]=[0,n.elapsed-e.elapsed];for(let l=0;l<sS;l++){let h=.5*(a+c);this._step(e,h,o);let u=s(e.elapsed+h,o);u?[c,r]=[h,u]:a=h}return this._step(e,c,o),t.end={elapsed:e.elapsed+c,state:o,step:0,count:n.count,event:r[0]},t.end}_firstStep(t){let e=new Float64Array(t.length);this._rates(this.time,t,e);let n=o=>Math.hypot(...o.map((a,c)=>a/(this.scale[c]+Math.abs(t[c])))),[s,r]=[n(t),n(e)];return s>1e-5&&r>1e-5?.01*s/r:1e-6}_tooFar(t,e){let[n,s]=[this.time+t.sense*e,this.time+t.from.elapsed];throw new RangeError(`t = ${n} s is more than ${this.mostSteps} steps away; t = ${s} s is reached, and kept. Ask again to go on, or ask for nearer times.`)}_stuck(t){throw new RangeError(`the motion cannot be followed beyond t = ${this.time+t.elapsed} s, where it changes faster than any step. Check the parameters; losses cannot be followed far backward.`)}};function rS(i,t){let[e,n]=[0,i.length];for(;n-e>1;){let s=e+n>>1;Math.abs(i[s].elapsed)<=t?e=s:n=s}return i[e]}function oS(i,t){let e=i.kept[i.kept.length-1];t.count<=e.count||t.count%i.spacing||(i.kept.push(t),!(i.kept.length<=tS)&&(i.spacing*=2,i.kept=i.kept.filter(({count:n})=>n%i.spacing===0)))}function Rr({moments:i,momentum:t,attitude:e=[1,0,0,0],epoch:n=0}){return{moments:Ar(i),momentum:pn("momentum",t,3,"kg m\xB2/s"),attitude:Tr(Er(e)),epoch:Se("epoch",n,"seconds")}}function Ho(i,t){let e=pn(i,t,3,"any unit: only the direction counts"),n=Math.max(...e.map(Math.abs));if(n>0){let s=e.map(o=>o/n),r=Math.hypot(...s);return s.map(o=>o/r)}throw new RangeError(`\`${i}\` must have a direction; got [0, 0, 0]. Give three numbers that are not all 0.`)}function qe(i,t,e,n=!1){if(Se(i,t,e)>0||n&&t===0)return t;let s=n?"not be negative":"be positive";throw new RangeError(`\`${i}\` must ${s}; got ${t}. Check its size, sign and unit, ${e}.`)}function Cr(i,t,e,n,s){let[r,o,a,c]=[i[0],i[1],i[2],i[3]];s[0]=-.5*(o*t+a*e+c*n),s[1]=.5*(r*t+a*n-c*e),s[2]=.5*(r*e+c*t-o*n),s[3]=.5*(r*n+o*e-a*t)}function Pr(i){let t=Math.sqrt(i[0]**2+i[1]**2+i[2]**2+i[3]**2);for(let e=0;e<4;e++)i[e]/=t}var Ir=i=>Array.from(i.subarray(0,4)),Lr=i=>Array.from(i.subarray(4,7)),be=(i,t)=>i[0]*t[0]+i[1]*t[1]+i[2]*t[2],Tl=(i,t)=>[i[1]*t[2]-i[2]*t[1],i[2]*t[0]-i[0]*t[2],i[0]*t[1]-i[1]*t[0]],Rl=(i,t)=>({"|L|\xB2":be(t,t),momentum_space:Vo(i,t)}),Nr=(i,t=[])=>[1,1,1,1,i,i,i,...t];var aS=6,cS=1,lS=9,Cl=class{constructor({mean_motion:t,eccentricity:e=0,mean_anomaly_at_start:n=0}){if(this.meanMotion=qe("mean_motion",t,"rad/s"),this.eccentricity=qe("eccentricity",e,"1",!0),!(this.eccentricity<1))throw new RangeError(`\`eccentricity\` must be below 1; got ${e}. Only ellipses come round again.`);this.meanAnomalyAtStart=Se("mean_anomaly_at_start",n,"rad")}place(t){let e=this.meanMotion*t+this.meanAnomalyAtStart,n=this.eccentricity,s=.5*hS(e-2*Math.PI*Math.round(e/(2*Math.PI)),n),[r,o]=[Math.sin(s),Math.cos(s)],a=1-n+2*n*r*r;return[(1-n-2*r*r)/a,2*Math.sqrt((1-n)*(1+n))*r*o/a,a]}};function hS(i,t){let e=Math.abs(i),n=Math.min(e+t,e/(1-t),t>0?Math.cbrt(Math.PI**2*e/t):1/0,Math.PI);for(let s=0;s<aS;s++){let r=1-t+2*t*Math.sin(.5*n)**2;n-=((1-t)*n-e+t*uS(n))/r}return n=Math.min(Math.max(n,0),Math.PI),i<0?-n:n}function uS(i){if(i>=cS)return i-Math.sin(i);let t=i**3/6,e=0;for(let n=1;n<=lS;n++)e+=t,t*=-(i*i)/((2*n+2)*(2*n+3));return e}var dS=1e-14,Wo=class{constructor({moments:t,rate:e=0,linear_drag:n=0,quadratic_drag:s=0,orbit:r=null,momentum:o,attitude:a,epoch:c}){let l=Rr({moments:t,momentum:o,attitude:a,epoch:c});this.moments=l.moments,this.epoch=l.epoch,this.rate=qe("rate",e,"s/(kg m\xB2)",!0);let h=typeof n=="number"?[n,n,n]:n;this.linearDrag=pn("linear_drag",h,3,"N m s").map(u=>qe("linear_drag",u,"N m s",!0)),this.quadraticDrag=qe("quadratic_drag",s,"N m s\xB2",!0),this.orbit=r===null?null:new Cl(r),this.torqued=this.orbit!==null||this.quadraticDrag>0||this.linearDrag.some(u=>u>0),this._balanced=this.torqued?["kinetic_energy","|L|\xB2"]:this.rate>0?["energy"]:[],this.orbit?.eccentricity===0&&this._balanced.push("jacobi_integral"),this._motion=new ni({rates:this._rates(),start:[...l.attitude,...l.momentum,...this._balanced.map(()=>0)],time:this.epoch,scale:this._scales(l.momentum),tolerance:dS,project:Pr})}_scales(t){let e=Math.max(...this.moments),n=Math.max(Math.hypot(...t),this.orbit?e*this.orbit.meanMotion:0)||e,s=this._balanced.map(r=>r==="|L|\xB2"?n*n:n*n/e);return Nr(n,s)}_rates(){return(t,e,n)=>{let s=this._at(t,[e[0],e[1],e[2],e[3]],[e[4],e[5],e[6]]),{momentum:r,velocity:o,drift:a,torque:c}=s,l=[o[0]+a[0],o[1]+a[1],o[2]+a[2]];Cr(e,l[0],l[1],l[2],n);let h=Tl(r,l);for(let u=0;u<3;u++)n[4+u]=h[u]+c[u];this._balanced.forEach((u,d)=>n[7+d]=this._power(u,s))}}_at(t,e,n){let s=[0,1,2].map(h=>n[h]/this.moments[h]),r=Tl(n,s),o=r.map(h=>this.rate*h),a=this.orbit?this._gravity(t,e):[0,0,0],c=this.quadraticDrag*Math.hypot(s[0],s[1],s[2]),l=[0,1,2].map(h=>a[h]-(this.linearDrag[h]+c)*s[h]);return{attitude:e,momentum:n,velocity:s,torqueless:r,drift:o,pull:a,torque:l}}_gravity(t,e){let[n,s,r]=this.orbit.place(t),o=as(e,[n,s,0]),a=Tl(o,o.map((l,h)=>this.moments[h]*l)),c=3*this.orbit.meanMotion**2/r**3;return a.map(l=>c*l)}_relative(t,e){let n=as(t,[0,0,1]);return e.map((s,r)=>s-this.orbit.meanMotion*n[r])}_power(t,{attitude:e,momentum:n,velocity:s,torqueless:r,drift:o,pull:a,torque:c}){let l=-be(o,r);if(t==="|L|\xB2")return 2*be(c,n);if(t!=="jacobi_integral")return be(c,s)+l;let h=c.map((u,d)=>u-a[d]);return be(h,this._relative(e,s))+l-be(a,o)}_jacobiIntegral(t,e,n){let[s,r]=this.orbit.place(t),[o,a]=[as(e,[s,r,0]),as(e,[0,0,1])],c=this._relative(e,n),l=this.orbit.meanMotion**2,h=c.map((u,d)=>u*u+l*(3*o[d]**2-a[d]**2));return .5*be(this.moments,h)}state(t){let e=this._motion.at(Se("t",t,"seconds")),[n,s]=[Ir(e),Lr(e)],r=s.map((u,d)=>u/this.moments[d]),o=.5*be(s,r),a={energy:o,kinetic_energy:o,"|L|\xB2":be(s,s)};this.orbit&&(a.jacobi_integral=this._jacobiIntegral(t,n,r));let c=this._balanced.map((u,d)=>[u,{value:a[u],received:e[7+d]}]),l=this.torqued?{}:Rl(n,s),h=this.torqued||this.rate>0?l:{energy:o,...l};return{attitude:n,momentum:s,velocity:r,energy:o,invariants:h,balances:Object.fromEntries(c),angleToMajorAxis:this._angleToMajorAxis(s)}}_angleToMajorAxis(t){if(!(Math.hypot(...t)>0))return null;let e=Math.max(...this.moments),n=t.map((s,r)=>this.moments[r]===e?s:0);return Math.atan2(Math.hypot(...t.map((s,r)=>s-n[r])),Math.hypot(...n))}};var fS=30,Ou={"air-layer":["viscosity","Pa s",!1,(i,{g:t,a:e},n)=>Math.PI*i*t*e*e/(n*n)],"boundary-layer":["coefficient","W s^(5/2)",!1,(i,t,e,n)=>i*n*n*Math.sqrt(n)],"viscous-contour-friction":["coefficient","W s\xB2",!1,(i,t,e,n)=>i*n*n],"dry-contour-friction":["coefficient","1",!1,(i,{m:t,g:e,a:n},s,r)=>i*t*e*n*r],"rolling-couple":["arm","m",!1,(i,{m:t,g:e},n,s)=>i*t*e*s*Math.sin(n)],"drilling-friction":["arm","m",!0,(i,{m:t,g:e},n,s)=>i*t*e*s*n*n]};function qp(i){if(!Array.isArray(i))throw new RangeError('`dissipation` must be a list of laws, like [{law: "air-layer", viscosity: 1.8e-5}].');return i.map((t,e)=>{let n=t!==null&&typeof t=="object"&&Object.hasOwn(Ou,t.law)&&Ou[t.law];if(!n){let l=Object.keys(Ou).join(", ");throw new RangeError(`\`dissipation[${e}].law\` must be one of ${l}; got ${JSON.stringify(t?.law)}.`)}let[s,r,o,a]=n,c=qe(`dissipation[${e}].${s}`,t[s],r);return{vertical:o,power:(l,h,u)=>a(c,l,h,u)}})}function Pl(i,t,e,n,s){let[r,o]=[0,0],[a,c]=[Math.sin(e),Math.cos(e)],l=Math.abs(a),[h,u]=[Math.min(e,Math.PI-e),Math.abs(n)/l];for(let d of t){let[f,p]=d.vertical?[a,c]:[-c/a,1],x=f*n+p*s,m=i.accelerations(f,p),g=fS*Math.sqrt(i.g/(i.a*l))/(f*m[0]+p*m[1]),y=d.power(i,h,u),S=y>=g*x*x?-x*g:-y/x;r+=f*S,o+=p*S}return[r,o]}var pS=.5772156649015329,Il=class{constructor(t){let e=mS(t);[this.near,this.far]=[[1],[]];let n=-pS;for(let o=0;o<64;o++)this.far.push(this.near[o]*(2*n-e[o])),this.near.push(this.near[o]*(o*(o+1)+t)/(o+1)**2),n+=1/(o+1);this.near.pop();let s=.25-t,r=Math.PI*Math.sqrt(Math.abs(s));this.sine=(s<0?Math.cosh(r):Math.cos(r))/Math.PI}values(t){let e=Math.sin(.5*t)**2,n=.5*Math.sin(t);if(e<=.5){let[h,u]=Fu(this.near,e);return[h,n*u]}let s=Math.cos(.5*t)**2,r=Math.log(s),[o,a]=Fu(this.near,s),[c,l]=Fu(this.far,s);return[this.sine*(c-r*o),-n*this.sine*(l-r*a-o/s)]}};function Xp(i,{m:t,a:e,C:n},s,r,o){let[a,c]=i.values(s),[l,h]=i.values(Math.PI-s),u=t*e*e*r/(n+t*e*e),d=-2*i.sine/Math.sin(s);return[(-h*o-l*u)/d,(a*u-c*o)/d]}function mS(i){let t=.25-i,e=new Array(65),n=64,[s,r]=t>=0?[Math.sqrt(t),0]:[0,Math.sqrt(-t)];e[64]=[1,-1].reduce((o,a)=>{let[c,l]=[Math.hypot(n+a*s,r),Math.atan2(a*r,n+a*s)],h=u=>Math.cos(u*l)/c**u;return o+Math.log(c)+h(2)/24-7*h(4)/960+31*h(6)/8064-127*h(8)/30720},0);for(let o=63;o>=0;o--)e[o]=e[o+1]-(2*o+1)/(o*(o+1)+i);return e}function Fu(i,t){let[e,n]=[0,0];for(let s=i.length-1;s>=0;s--)n=e+t*n,e=i[s]+t*e;return[e,n]}var Ll=class{constructor({m:t,a:e,b:n,A:s,C:r,g:o}){Object.assign(this,{m:t,a:e,b:n,A:s,C:r,g:o})}tiltAcceleration(t,e,n){let{m:s,a:r,b:o,A:a,C:c,g:l}=this,[h,u]=[Math.sin(t),Math.cos(t)];return((a+s*o*o)*e*e*u/h+s*r*o*e*(e-n*u/h)-(c+s*r*r)*e*n-s*l*(r*u-o*h))/(a+s*r*r+s*o*o)}tiltDerivatives(t,e,n){let{m:s,a:r,b:o,A:a,C:c,g:l}=this,[h,u]=[Math.sin(t),Math.cos(t)],[d,f,p]=[a+s*o*o,c+s*r*r,s*r*o],x=a+s*r*r+s*o*o,m=(p*e*n-d*e*e)/(h*h)+s*l*(r*h+o*u),g=2*d*e*u/h+2*p*e-p*n*u/h-f*n,y=-p*e*u/h-f*e;return[m/x,g/x,y/x]}transport(t,e,n){let{m:s,a:r,b:o,A:a,C:c}=this,l=Math.cos(t)/Math.sin(t);return this.accelerations(c*n-(a+s*o*o)*e*l-s*r*o*e,s*r*(r+o*l)*e)}accelerations(t,e){let{m:n,a:s,b:r,A:o,C:a}=this,[c,l,h]=[o+n*r*r,a+n*s*s,n*s*r],u=o*a+n*s*s*o+n*r*r*a;return[(l*t+h*e)/u,(h*t+c*e)/u]}energy(t,e,n,s){let{m:r,a:o,b:a,A:c,C:l,g:h}=this,u=(a*n-o*s)**2+(o*o+a*a)*e*e,d=o*Math.sin(t)-2*a*Math.sin(.5*t)**2;return .5*(c*(e*e+n*n)+l*s*s+r*u)+r*h*d}normalForce(t,e,n,s){let{m:r,a:o,b:a,g:c}=this,[l,h]=[Math.sin(t),Math.cos(t)];return r*(c+(o*h-a*l)*this.tiltAcceleration(t,n,s)-(o*l+a*h)*e*e)}};var gS=1e-9;function $p(i,t,e,n){let{m:s,a:r,b:o,A:a,C:c,g:l}=i,[h,u]=[Math.sin(t),Math.cos(t)],d=s*l*(r*u-o*h),[f,p]=[e,n];if(f===null){if(f=Math.sqrt(d/(a*h*u-c*h*h*o/r)),!Number.isFinite(f)||!(f>0))throw new RangeError(`no steady motion has its centre at rest at tilt ${t} rad. Give \`precession\`.`);p??=f*h*o/r}let x=Se("precession",f,"rad/s")*h;if(p??=(((a+s*o*o)*u+s*r*o*h)*h*f**2-d)/(((c+s*r*r)*h+s*r*o*u)*f),!Number.isFinite(p))throw new RangeError("`spin` must be given where nothing precesses, as in straight rolling.");let m=i.tiltAcceleration(t,x,p);if(Math.abs(m)<=gS*(l/r+x*x+p*p))return[x,p];throw new RangeError(`tilt ${t} rad, \`precession\` ${f} and \`spin\` ${p} rad/s are not steady: the tilt would accelerate by ${m} rad/s\xB2. Give one of the rates only.`)}function Yp(i,t,e,n,s){if(!t.length)return 0;let[r,o,a]=i.tiltDerivatives(e,n,s),[c,l]=i.transport(e,n,s),h=-(r+o*c+a*l);if(!(h>0))throw new RangeError(`the steady motion at tilt ${e} rad is unstable: no slow manifold to start on. Give another tilt.`);let[u,d]=i.accelerations(...Pl(i,t,e,n,s));return(o*u+a*d)/h}var xS=1e-14,Bu=1e-6,_S=.001,yS=9.80665,Zp=["tilt","heading","face","contact_x","contact_y","tilt_rate","rise_rate","spin"],Dr=class{constructor({start:t,epoch:e=0,...n}){let{disk:s,laws:r}=Jp(n),{m:o,a,b:c,A:l,C:h,g:u}=s;this.moments=[l,l,h],this.onPlane=!0,[this.radius,this.halfThickness]=[a,c],this.epoch=Se("epoch",e,"seconds"),this.thin=c===0,[this._disk,this._laws]=[s,r],this._legendre=this.thin&&!r.length?new Il(o*a*a*h/(l*(h+o*a*a))):null;let d=Math.sqrt(u/a);this._motion=new ni({rates:this._rates(),start:[...vS(t,this.thin),0],time:this.epoch,scale:[_S,1,1,a,a,d,d,d,o*u*a],tolerance:xS,stops:this._stops(o*u)})}static rollingStart({tilt:t,precession:e=null,spin:n=null,heading:s=0,face:r=0,...o}){let{disk:a,laws:c}=Jp(o);Kp(Se("tilt",t,"rad"),a.b===0);let l=$p(a,t,e,n);return[t,s,r,0,0,Yp(a,c,t,...l),...l]}_stops(t){let e={flat:(n,s)=>Math.sin(s[0])-Bu,"lift-off":(n,s)=>this._disk.normalForce(s[0],s[5],s[6],s[7])/t};return this.thin?e:{...e,"on edge":(n,s)=>Math.cos(s[0])}}_rates(){let[t,e]=[this._disk,this._laws];return(n,s,r)=>{let[o,a,c,l,h]=[s[0],s[1],s[5],s[6],s[7]],u=l/Math.sin(o),d=h-u*Math.cos(o),[f,p]=Pl(t,e,o,l,h),[x,m]=t.accelerations(f,p),[g,y]=t.transport(o,l,h);r[0]=c,r[1]=u,r[2]=h+2*u*Math.sin(.5*o)**2,r[3]=-t.a*d*Math.cos(a),r[4]=-t.a*d*Math.sin(a),r[5]=t.tiltAcceleration(o,l,h),r[6]=g*c+x,r[7]=y*c+m,r[8]=f*l+p*h}}get end(){return this._motion.end()}state(t){let e=Se("t",t,"seconds"),[n,s,r,o,a,c,l,h,u]=this._motion.at(e),d=this._disk,[f,p]=[Math.sin(n),Math.cos(n)],[x,m,g]=[-Math.sin(s),Math.cos(s),d.b],y=r-s,S=[Math.cos(y)*c+Math.sin(y)*l,Math.cos(y)*l-Math.sin(y)*c,h],v=d.energy(n,c,l,h),A=this._motion.end(t>=this.epoch);return{attitude:MS(n,s,r),momentum:S.map((w,_)=>this.moments[_]*w),velocity:S,energy:v,tilt:n,heading:s,face:r,invariants:this._invariants(v,n,l,h),balances:this._laws.length?{energy:{value:v,received:u}}:{},contact:[o,a],center:[o+x*(d.a*p-g*f),a+m*(d.a*p-g*f),d.a*f+g*p],normalForce:d.normalForce(n,c,l,h),parts:[n,s,r,o,a,c,l,h],ended:A&&Math.abs(t-this.epoch)>=Math.abs(A.time-this.epoch)?A.event:null}}_invariants(t,e,n,s){if(this._laws.length)return{};if(!this._legendre)return{energy:t};let[r,o]=Xp(this._legendre,this._disk,e,n,s);return{energy:t,linear_integral_1:r,linear_integral_2:o}}};function Jp({mass:i,radius:t,half_thickness:e=0,axial_moment:n,diametral_moment:s,gravity:r=yS,dissipation:o=[]}){let[a,c,l]=[qe("mass",i,"kg"),qe("radius",t,"m"),qe("gravity",r,"m/s\xB2")],h=qe("half_thickness",e,"m",!0);if(h>c)throw new RangeError(`\`half_thickness\` must be at most the radius, ${c} m; got ${h}. Check units.`);let u=qe("axial_moment",n??.5*a*c*c,"kg m\xB2"),d=qe("diametral_moment",s??a*(.25*c*c+h*h/3),"kg m\xB2");if(u>2*d*(1+1e-12))throw new RangeError(`\`axial_moment\` must be at most twice \`diametral_moment\`; got ${u} and ${d} kg m\xB2. Check units.`);return{disk:new Ll({m:a,a:c,b:h,A:d,C:u,g:l}),laws:qp(o)}}function vS(i,t){let e=pn("start",i,Zp.length,`SI units: ${Zp.join(", ")}`);return Kp(e[0],t),e}function Kp(i,t){let e=t?Math.PI:.5*Math.PI;if(!(i>0&&i<e&&Math.sin(i)>Bu))throw new RangeError(`the tilt at the start must lie between ${Bu} rad and ${t?"\u03C0 less that":"\u03C0/2 for a thick disk"}; got ${i} rad. A disk that lies flat does not roll: start at a small tilt, such as 0.1.`)}function MS(i,t,e){let[n,s]=[Math.sin(.5*i),Math.cos(.5*i)],[r,o]=[.5*e,t-.5*e];return[s*Math.cos(r),n*Math.cos(o),n*Math.sin(o),s*Math.sin(r)]}var SS=1e-14,qo=class{constructor({moments:t,rotor:e,rotor_moment:n=null,rotor_drive:s="constant-rate",axis:r=null,momentum:o,attitude:a,epoch:c}){let l=Rr({moments:t,momentum:o,attitude:a,epoch:c});if(this.moments=l.moments,this.epoch=l.epoch,this.rotor=pn("rotor",e,3,"kg m\xB2/s"),this.rotorMoment=n===null?null:qe("rotor_moment",n,"kg m\xB2"),!["constant-rate","free"].includes(s))throw new RangeError(`\`rotor_drive\` must be "constant-rate" or "free"; got ${JSON.stringify(s)}.`);this.free=s==="free";let h=Math.hypot(...this.rotor)>0;this.axis=r===null?h&&Ho("rotor",this.rotor):Ho("axis",r);let u=Math.max(Math.hypot(...l.momentum),Math.hypot(...this.rotor))||Math.max(...this.moments);this._motion=new ni({rates:this._rates(),start:[...l.attitude,...l.momentum],time:this.epoch,scale:Nr(u),tolerance:SS,project:Pr})}_rates(){let[t,e,n]=this.moments,[s,r,o]=this.rotor;return(a,c,l)=>{let[h,u,d]=[c[4],c[5],c[6]],[f,p,x]=[(h-s)/t,(u-r)/e,(d-o)/n];Cr(c,f,p,x,l),l[4]=u*x-d*p,l[5]=d*f-h*x,l[6]=h*p-u*f}}state(t){let e=this._motion.at(Se("t",t,"seconds")),[n,s]=[Ir(e),Lr(e)],r=s.map((l,h)=>l-this.rotor[h]),o=r.map((l,h)=>l/this.moments[h]),a=.5*be(r,o),c={energy:a,...Rl(n,s)};return{attitude:n,momentum:s,velocity:o,energy:a,invariants:c,rotorRate:this.rotorRate(o)}}rotorRate(t){return this.rotorMoment===null||!this.axis?null:be(this.rotor,this.axis)/this.rotorMoment-(this.free?be(t,this.axis):0)}};var Ur=1e-12,bS=1e-12;function jp(i,t,e,n){if(t===0)return["Euler's |\u03A0|\xB2",s=>be(s,s)];if(wS(i,e))return["Lagrange's \u03A0\xB7\u03C7",s=>be(s,e)];for(let s=0;s<3;s++){let[r,o]=Qp(s);if(!tm(i[r],i[o])||Math.abs(e[s])>Ur)continue;let a={moments:i,axis:e,i:r,j:o,k:s,strength:t/i[s]};if(Math.abs(i[r]/2-i[s])<=Ur*i[s])return["Kovalevskaya's integral",ES(a)];if(Math.abs(i[r]/4-i[s])<=Ur*i[s])return["Goryachev and Chaplygin's integral",AS(...n)?TS(a):()=>NaN]}return null}var Qp=i=>[(i+1)%3,(i+2)%3],tm=(i,t)=>Math.abs(i-t)<=Ur*i;function wS(i,t){let e=Math.max(...i);return e-Math.min(...i)<=Ur*e?!0:[0,1,2].some(n=>{let[s,r]=Qp(n);return tm(i[s],i[r])&&Math.abs(t[s])+Math.abs(t[r])<=Ur})}var AS=(i,t)=>Math.abs(be(i,t))<=bS*Math.hypot(...i)*Math.hypot(...t);function ES({moments:i,axis:t,i:e,j:n,strength:s}){return(r,o)=>{let[a,c]=[r[e]/i[e],r[n]/i[n]],l=a*a-c*c-s*(o[e]*t[e]-o[n]*t[n]),h=2*a*c-s*(o[e]*t[n]+o[n]*t[e]);return l*l+h*h}}function TS({moments:i,axis:t,i:e,j:n,k:s,strength:r}){return(o,a)=>{let c=o.map((l,h)=>l/i[h]);return c[s]*(c[e]**2+c[n]**2)-r*be(c,t)*a[s]}}var RS=1e-14,Xo=class{constructor({moments:t,mgl:e,axis:n=[0,0,1],momentum:s,attitude:r,epoch:o}){let a=Rr({moments:t,momentum:s,attitude:r,epoch:o});this.moments=a.moments,this.epoch=a.epoch,this.mgl=Se("mgl",e,"N m"),this.axis=Ho("axis",n);let c=as(a.attitude,[0,0,1]);this._third=jp(this.moments,this.mgl,this.axis,[a.momentum,c]);let l=Math.max(...this.moments),h=Math.max(Math.hypot(...a.momentum),Math.sqrt(Math.abs(this.mgl)*l))||l;this._motion=new ni({rates:this._rates(),start:[...a.attitude,...a.momentum],time:this.epoch,scale:Nr(h),tolerance:RS,project:Pr})}_rates(){let[t,e,n]=this.moments,[s,r,o]=this.axis.map(a=>this.mgl*a);return(a,c,l)=>{let[h,u,d,f]=[c[0],c[1],c[2],c[3]],[p,x,m]=[c[4],c[5],c[6]],[g,y,S]=[p/t,x/e,m/n];Cr(c,g,y,S,l);let[v,A,w]=[2*(u*f-h*d),2*(d*f+h*u),h*h-u*u-d*d+f*f];l[4]=x*S-m*y+A*o-w*r,l[5]=m*g-p*S+w*s-v*o,l[6]=p*y-x*g+v*r-A*s}}state(t){let e=this._motion.at(Se("t",t,"seconds")),[n,s]=[Ir(e),Lr(e)],r=s.map((l,h)=>l/this.moments[h]),o=as(n,[0,0,1]),a=.5*be(s,r)+this.mgl*be(o,this.axis),c={energy:a,"|P|\xB2":be(o,o),"\u03A0\xB7P":be(s,o)};return this._third&&(c[this._third[0]]=this._third[1](s,o)),{attitude:n,momentum:s,velocity:r,energy:a,invariants:c}}};var $o=2*Math.PI,CS=[.08,.25,.5,.75],PS=2400,zu=160,IS=.05,Wn=i=>[0,1,2].sort((t,e)=>i[t]-i[e]||t-e);function LS(i){let[t,e,n]=Wn(i);return i[t]<i[e]&&i[e]<i[n]}function zs(i,t,e=PS){let n=Wn(i),[s,r,o]=n.map(y=>i[y]),[a,c,l]=n.map(y=>t[y]/Math.hypot(...t));if(s===o)return null;let h=s*(o-r)*l*l-o*(r-s)*a*a;if(h===0&&s<r&&r<o)return null;let u=h>0,d=u?s*(o-r)/(r*(o-s)):o*(r-s)/(r*(o-s)),f=u?a:l,p=Math.sqrt(c*c+(d>0?f*f/d:0)),x=Math.sqrt(f*f+d*c*c);if(x===0||!(p<=1+1e-12))return null;let m=Math.sign(u?l:a)||1,g=[];for(let y of NS(Math.min(p,1),e)){let[S,v]=[x*Math.cos(y),p*Math.sin(y)],A=m*Math.sqrt(Math.max(0,1-S*S-v*v)),w=[0,0,0];[w[n[0]],w[n[1]],w[n[2]]]=u?[S,v,A]:[A,v,S],g.push(...w)}return g}function NS(i,t){let e=[];for(let s=0;s<t;s++)e.push($o*s/t);let n=Math.sqrt(Math.max(0,1-i*i));for(let s=.02*n;n>0&&s<.5;s+=IS*Math.max(s,.4*n)){let r=Math.asin(s);for(let o of[.25*$o,.75*$o])e.push(o-r,o+r)}return e.push($o),e.sort((s,r)=>s-r)}function nm(i){let t=Wn(i),[e,n,s]=t.map(o=>i[o]);if(e===s)return[];let r=[e<n,e===s,n<s];return t.flatMap((o,a)=>[1,-1].map(c=>{let l=[0,0,0];return l[o]=c,{at:l,verdict:r[a]?"stable":"unstable"}}))}function im(i){let t=Wn(i),[e,n,s]=t.map(a=>i[a]),r=[];if(e===s)return r;let o=Math.atan2(Math.sqrt((s-n)*e),Math.sqrt((n-e)*s));for(let[a,c,l]of[[t[2],t[0],o],[t[0],t[2],.5*Math.PI-o]])if(!(l<1e-9))for(let h of CS){let u=[0,0,0];[u[a],u[c]]=[Math.cos(h*l),Math.sin(h*l)],r.push(...Yo(i,u))}return r}function Yo(i,t){let e=zs(i,t,zu);return e?[...ku(e),...ku(e.map(n=>-n))]:[]}function sm(i){if(!LS(i))return[];let t=Wn(i),[e,n,s]=t.map(a=>i[a]),r=Math.atan2(Math.sqrt((s-n)*e),Math.sqrt((n-e)*s)),o=[];for(let a of[1,-1]){let c=[];for(let l=0;l<=zu;l++){let h=[0,0,0],u=$o*l/zu;h[t[1]]=Math.cos(u),h[t[0]]=a*Math.sin(u)*Math.sin(r),h[t[2]]=Math.sin(u)*Math.cos(r),c.push(...h)}o.push(...ku(c))}return o}var pi=64,em=9;function rm(i,t,e){if(!(e>0))return[];let n=c=>c.reduce((l,h,u)=>l+(e*h-t[u])**2/i[u],0),s=[],[r,o]=[1/0,-1/0];for(let c=0;c<6;c++){let l=[];for(let h=0;h<=pi;h++)for(let u=0;u<=pi;u++){let d=[0,0,0];d[c%3]=c<3?1:-1,d[(c+1)%3]=Math.tan((2*h/pi-1)*.25*Math.PI),d[(c+2)%3]=Math.tan((2*u/pi-1)*.25*Math.PI);let f=Math.hypot(...d),p=d.map(m=>m/f),x=n(p);[r,o]=[Math.min(r,x),Math.max(o,x)],l.push([p,x])}s.push(l)}let a=[];if(!(o-r>1e-12*Math.abs(o)))return a;for(let c of s)for(let l=0;l<pi;l++)for(let h=0;h<pi;h++){let[u,d,f,p]=[c[l*(pi+1)+h],c[(l+1)*(pi+1)+h],c[(l+1)*(pi+1)+h+1],c[l*(pi+1)+h+1]];for(let x of[[u,d,f],[u,f,p]])DS(x,r,o,a)}return a}function DS(i,t,e,n){let s=i.map(([,c])=>c),r=(e-t)/(em+1),o=Math.max(1,Math.ceil((Math.min(...s)-t)/r)),a=Math.min(em,Math.floor((Math.max(...s)-t)/r));for(let c=o;c<=a;c++){let l=t+c*r,h=[];for(let u=0;u<3;u++){let[[d,f],[p,x]]=[i[u],i[(u+1)%3]];if(f<l==x<l)continue;let m=(l-f)/(x-f),g=d.map((S,v)=>S+m*(p[v]-S)),y=Math.hypot(...g);h.push(g.map(S=>S/y))}h.length===2&&n.push(...h[0],...h[1])}}function ku(i){let t=[];for(let e=0;e+5<i.length;e+=3)t.push(...i.slice(e,e+6));return t}var Gu={"-":"\u207B",0:"\u2070",1:"\xB9",2:"\xB2",3:"\xB3",4:"\u2074",5:"\u2075",6:"\u2076",7:"\u2077",8:"\u2078",9:"\u2079"};function $t(i,t=6){if(i===0)return"0";let e=Math.abs(i);if(e>=.001&&e<1e6)return(e>=10**t?String(Number(i.toPrecision(t))):i.toPrecision(t)).replace("-","\u2212");let[n,s]=i.toExponential(t-1).split("e"),r=[...s.replace("+","")].map(o=>Gu[o]).join("");return`${n}\xB710${r}`.replace("-","\u2212")}var US=[[31557600,"yr"],[86400,"d"],[3600,"h"],[60,"min"]],OS=[[1,"s"],[.001,"ms"],[1e-6,"\xB5s"],[1e-9,"ns"],[1e-12,"ps"],[1e-15,"fs"]];function Vu(i){return US.find(([t])=>i>=3*t)??OS.find(([t])=>i>=.3*t)??null}function ii(i,t){let[e,n]=Vu(t)??[null];return e?`${(i/e).toFixed(FS(t/e))} ${n}`:`${$t(i,4)} s`}var FS=i=>Math.max(0,Math.min(4,4-Math.ceil(Math.log10(Math.max(i,1e-9))))),Vt=i=>String(i);var Hu=Math.PI/30,om=Math.PI/180;function Ze(i,t){let[e,n,s]=[0,1,2].map(r=>i[(t+r)%3]);return{rate:Math.hypot(...i),tilt:Math.atan2(Math.hypot(n,s),e),around:n||s?Math.atan2(s,n):0}}function am(i,{rate:t,tilt:e,around:n}){let s=[0,0,0];return s[i]=t*Math.cos(e),s[(i+1)%3]=t*Math.sin(e)*Math.cos(n),s[(i+2)%3]=t*Math.sin(e)*Math.sin(n),s}var cs={rate:1,about:1,tilt:1,angular_velocity:3,momentum:3,attitude:4},Cn=(i,t)=>`[${i.map(e=>`"${Vt(e)} ${t}"`).join(", ")}]`,ls=i=>i.map(Math.abs).reduce((t,e,n,s)=>e>s[t]?n:t,0),hs=i=>i.map((t,e)=>({key:`body.moments.${e}`,label:`moment of inertia I${"\u2081\u2082\u2083"[e]}`,unit:"kg m\xB2",value:t,...BS(i,e)}));function BS(i,t){let[e,n]=[i[(t+1)%3],i[(t+2)%3]],[s,r]=[Math.abs(e-n),e+n];return{low:Math.max(s,.001*r),high:r,log:!0}}function us({velocity:i,about:t,around:e}){let{rate:n,tilt:s}=Ze(i,t),r=n<.001*Hu||n>1e6*Hu;return[{key:"spin.rate",label:"spin rate |\u03A9|",unit:r?"rad/s":"rpm",si:r?1:Hu,value:n,log:!0,low:n/20||.1,high:20*n||100},{key:"spin.about",label:"tilt counted from",value:t,choices:[0,1,2].map(o=>[o,`axis ${o+1}`])},{key:"spin.tilt",label:"tilt of the spin",unit:"\xB0",si:om,value:s,low:0,high:Math.PI,power:2},{key:"spin.around",label:`tilted towards (0\xB0 is axis ${(t+1)%3+1})`,unit:"\xB0",si:om,value:s>0?Ze(i,t).around:e,low:-Math.PI,high:Math.PI}]}function ds(i,t,e){let[,n,s]=t.split(".");if(n==="moments"){let o=i.moments.map((a,c)=>c===Number(s)?e:a);return{...i,moments:o,momentum:null}}if(n==="about")return{...i,about:e,around:Ze(i.velocity,e).around};let r={...Ze(i.velocity,i.about)};return r.tilt>0||(r.around=i.around),r[n]=e,{...i,velocity:am(i.about,r),around:r.around,momentum:null}}function fs(i,{body:t={},spin:e={}},n=[0,0,0]){let s={...i};if(t.moments&&(s={...s,moments:GS(t.moments),momentum:null}),e.attitude&&(s.attitude=e.attitude.map(Number)),e.momentum){let d=e.momentum.map(Number),f=d.map((p,x)=>(p-n[x])/s.moments[x]);return{...s,momentum:d,velocity:f,around:Ze(f,s.about).around}}if(e.angular_velocity){let d=e.angular_velocity.map(Number);return{...s,momentum:null,velocity:d,around:Ze(d,s.about).around}}if(["rate","about","tilt"].every(d=>e[d]===void 0))return s;if(e.about!==void 0&&![1,2,3].includes(e.about))throw new RangeError(`spin.about must be 1, 2 or 3, a principal axis; got ${e.about}.`);let r=kS(s.moments),o=e.about===void 0?r.findIndex(d=>d[s.about]!==0):e.about-1,a=Ze(r.map(d=>zS(d,s.velocity)),o),c={rate:e.rate??a.rate,tilt:e.tilt??a.tilt,around:e.tilt===void 0?a.around:0},l=am(o,c),h=[0,1,2].map(d=>r.reduce((f,p,x)=>f+p[d]*l[x],0)),u=r[o].findIndex(d=>d!==0);return{...s,about:u,around:Ze(h,u).around,momentum:null,velocity:h}}var zS=(i,t)=>i.reduce((e,n,s)=>e+n*t[s],0);function kS(i){let t=Wn(i),e=(t[1]-t[0])*(t[2]-t[0])*(t[2]-t[1])<0;return t.map((n,s)=>[0,1,2].map(r=>r===n?e&&s===2?-1:1:0))}function GS(i){let t=i[0]+i[1]+i[2];if(i.every(e=>e>0&&2*e<=t*(1+1e-9)))return i;throw new RangeError(`Moments must be positive and satisfy I1 + I2 \u2265 I3; got ${i.join(", ")} kg m\xB2. No rigid body has these.`)}var qn=({moments:i,velocity:t,momentum:e},n=[0,0,0])=>e??t.map((s,r)=>s*i[r]+n[r]);var VS=2e3,HS=5*Math.PI/180,WS=["rate","spin.tilt","spin.rate"],qS={body:{moments:3},system:{kind:0,damping:1,sink_rate:1,linear_drag:1,quadratic_drag:1},spin:cs};function XS({moments:i,rate:t=0,linear_drag:e=0,quadratic_drag:n=0,momentum:s,attitude:r=[1,0,0,0],epoch:o=0}){let a=s.map((l,h)=>l/i[h]),c=ls(a);return{moments:i,velocity:a,attitude:r,epoch:o,about:c,around:Ze(a,c).around,momentum:s,rate:t,linear_drag:e,quadratic_drag:n}}function $S(i){let t=1/(Math.hypot(...qn(i))||1);return[{key:"rate",label:"losses inside, \u03B1",unit:"s/(kg m\xB2)",value:i.rate,low:0,high:5*Math.max(i.rate,.02*t),power:2},...hs(i.moments),...us(i)]}var YS=(i,t,e)=>t==="rate"?{...i,rate:e}:ds(i,t,e),ZS=i=>new Wo({...i,momentum:qn(i)}),JS=({moments:i,rate:t,linear_drag:e,quadratic_drag:n,velocity:s,attitude:r})=>({body:{moments:i},system:{kind:"damped-body",sink_rate:t,linear_drag:e,quadratic_drag:n},spin:{angular_velocity:s,attitude:r}});function KS(i,t){let{system:e={}}=t,n={...i};for(let[o,a]of[["sink_rate","rate"],["linear_drag","linear_drag"],["quadratic_drag","quadratic_drag"]])e[o]!==void 0&&(n[a]=e[o]);let s=fs(n,t);if(e.damping===void 0)return s;let r=Math.hypot(...qn(s));return{...s,rate:r>0?e.damping/r:0}}function jS(i,t){let{moments:e,rate:n,linear_drag:s,quadratic_drag:r,velocity:o,attitude:a}=i,c=Math.hypot(...qn(i)),l=n>0&&c>0?`damping = ${Vt(n*c)}
`:"",h=s>0?`linear_drag = "${Vt(s)} N*m*s"
`:"",u=r>0?`quadratic_drag = "${Vt(r)} N*m*s^2"
`:"";return!l&&!h&&!u?null:`[body]
moments = ${Cn(e,"kg*m^2")}

[system]
kind = "damped-body"
${l}${h}${u}
[spin]
angular_velocity = ${Cn(o,"rad/s")}
attitude = [${a.map(Vt).join(", ")}]

[time]
until = "${Vt(t)} s"
`}function QS({moments:i,velocity:t,rate:e},n){let{energy:s,momentum:r}=n.state(n.epoch),o=Math.hypot(...r);if(!(o>0))return[["what it does","at rest"]];let[a,,c]=Wn(i).map(d=>i[d]),l=[["what it does",e>0&&a<c?"loses energy and ends spinning about its axis of largest moment":"keeps |L|"]],h=o*o/(2*c);l.push(["energy it can lose inside",`${$t(100*(s-h)/s,3)} %`]);let u=e>0?cm(n,Math.hypot(...t)):null;return u!==null&&l.push(["within 5\xB0 of the flat spin after",ii(u,u)]),l}var tb=({velocity:i,rate:t},e)=>t>0?cm(e,Math.hypot(...i)):null;function cm(i,t){let e=2*Math.PI/t/4,n=null;for(let s=0;s<4*VS;s++){let{angleToMajorAxis:r}=i.state(i.epoch+s*e);if(!(r<HS))n=null;else{if((n??=s*e)<.5*s*e)return n;if(n===0)return 0}}return n}var Xu={};qi(Xu,{asSpec:()=>cb,changed:()=>ob,controls:()=>rb,facts:()=>ub,from:()=>ib,keys:()=>nb,make:()=>ab,toml:()=>hb,withSpec:()=>lb});var qu=Math.PI/180,eb=.02,Zo={"air-layer":["viscosity","Pa*s","viscosity of the air"],"boundary-layer":["coefficient","W*s^2.5","loss in the boundary layer"],"viscous-contour-friction":["coefficient","W*s^2","viscous friction of the contact"],"dry-contour-friction":["coefficient","","dry friction of the contact"],"rolling-couple":["arm","m","lever arm of rolling friction"],"drilling-friction":["arm","m","lever arm of drilling friction"]},nb={system:{kind:0,mass:1,radius:1,thickness:1,gravity:1,tilt:1},dissipation:Object.fromEntries(Object.keys(Zo).map(i=>[i,1]))};function ib({mass:i,radius:t,half_thickness:e,diametral_moment:n,axial_moment:s,gravity:r,dissipation:o,start:a,epoch:c=0}){let h=Math.abs(s-.5*i*t**2)<1e-12*s&&Math.abs(n-i*(.25*t**2+e**2/3))<1e-12*n?null:[n/(i*t**2),s/(i*t**2)],u={mass:i,radius:t,half_thickness:e,shares:h,gravity:r,dissipation:o,tilt:a[0],heading:a[1],face:a[2],start:a,epoch:c};return{...u,moments:Dl(u),steady:sb(u)}}var Dl=({shares:i,mass:t,radius:e,half_thickness:n})=>{let[s,r]=i?i.map(o=>o*t*e**2):[t*(.25*e**2+n**2/3),.5*t*e**2];return[s,s,r]},lm=i=>{let[t,,e]=Dl(i),{mass:n,radius:s,half_thickness:r,gravity:o,dissipation:a}=i,c=Object.entries(a).map(([l,h])=>({law:l,[Zo[l][0]]:h}));return{mass:n,radius:s,half_thickness:r,gravity:o,diametral_moment:t,axial_moment:e,dissipation:c}},hm=i=>Dr.rollingStart({...lm(i),tilt:i.tilt,heading:i.heading,face:i.face});function sb(i){try{let t=hm(i),e=Math.hypot(...t.slice(6));return[6,7].every(n=>Math.abs(t[n]-i.start[n])<eb*e)}catch{return!1}}function rb(i){let{tilt:t,radius:e,half_thickness:n,mass:s,gravity:r,dissipation:o}=i;return[{key:"tilt",label:"tilt of the face at first",unit:"\xB0",si:qu,value:t,low:Math.min(t,qu),high:80*qu,log:!0},{key:"radius",label:"radius",unit:"mm",si:.001,value:e,low:e/5,high:5*e,log:!0},{key:"thickness",label:"thickness",unit:"mm",si:.001,value:2*n,low:0,high:e},{key:"mass",label:"mass",unit:"g",si:.001,value:s,low:s/20,high:20*s,log:!0},{key:"gravity",label:"gravity",unit:"m/s\xB2",value:r,low:r/10,high:3*r,log:!0},...Object.entries(o).map(([a,c])=>({key:`law.${a}`,label:Zo[a][2],unit:Zo[a][1].replace("*"," ").replace("^2.5","^(5/2)").replace("^2","\xB2"),value:c,low:c/100,high:100*c,log:!0}))]}function ob(i,t,e){let[n,s]=t.split(".");return Nl(s?{...i,dissipation:{...i.dissipation,[s]:e}}:n==="thickness"?{...i,half_thickness:.5*e}:{...i,[n]:e})}function Nl(i){let t={...i,steady:!0,epoch:0};return{...t,start:hm(t),moments:Dl(t)}}var ab=i=>new Dr({...lm(i),start:i.start,epoch:i.epoch}),cb=({mass:i,radius:t,half_thickness:e,gravity:n,tilt:s,dissipation:r})=>({system:{kind:"euler-disk",mass:i,radius:t,thickness:2*e,gravity:n,tilt:s},dissipation:r});function lb(i,{system:t={},dissipation:e={}}){let n={...i,dissipation:{...i.dissipation,...e}};for(let[s,r]of Object.entries(n.dissipation))r===0&&delete n.dissipation[s];for(let s of["mass","radius","gravity","tilt"])t[s]!==void 0&&(n[s]=t[s]);return t.thickness!==void 0&&(n.half_thickness=.5*t.thickness),Nl(n)}function hb(i,t){if(!i.steady)return null;let{mass:e,radius:n,half_thickness:s,shares:r,gravity:o,tilt:a,heading:c,dissipation:l}=i,[h,,u]=Dl(i),d=r?`axial_moment = "${Vt(u)} kg*m^2"
diametral_moment = "${Vt(h)} kg*m^2"
`:"",f=Object.entries(l).map(([p,x])=>{let[m,g]=Zo[p];return`{ law = "${p}", ${m} = ${g?`"${Vt(x)} ${g}"`:Vt(x)} }`});return`[system]
kind = "euler-disk"
mass = "${Vt(e)} kg"
radius = "${Vt(n)} m"
thickness = "${Vt(2*s)} m"
${d}gravity = "${Vt(o)} m/s^2"
tilt = "${Vt(a)} rad"
heading = "${Vt(c)} rad"
dissipation = [${f.join(", ")}]

[time]
until = "${Vt(t)} s"
`}function ub(i,t){let e=t.state(t.epoch),n=e.parts[6]/Math.sin(e.tilt),s=2*Math.PI/Math.abs(n),r=t.state(t.epoch+20*s),o=r.balances.energy?r.balances.energy.received-e.balances.energy.received:0,a=[["contact goes round every",`${$t(s,4)} s`],["energy at first",`${$t(e.energy,5)} J`],["energy less losses, change in 20 rounds",$t(Math.abs(r.energy-o-e.energy)/e.energy,2)]];return o&&a.push(["lost in 20 rounds",`${$t(-100*o/e.energy,3)} %`]),r.ended&&a.push(["ends",r.ended==="flat"?"flat on the table, within 20 rounds":`by ${r.ended}, within 20 rounds`]),a}var Ku={};qi(Ku,{asSpec:()=>xw,changed:()=>pw,controls:()=>dw,dragged:()=>cw,event:()=>Mw,facts:()=>vw,first:()=>lw,from:()=>uw,keys:()=>hw,make:()=>gw,toml:()=>yw,withDirection:()=>mw,withSpec:()=>_w});var um=2e-8,db=20;function dm(i,t,e){let n=vt(Tt(i,t),.5),s=.5*(i[0]-t[0]+(i[1]-t[1])),r=ne(e,Hn(n)),o=r[0]+r[1]+s*s;return{x:s/n[0],e:o/(2*n[0]*n[0]+o),middle:n}}function Jo(i,t,e){let n=Math.min(Ye(i[0]),0),s=2**n,r=2**-n;[i,t,e]=[vt(i,r),vt(t,r),vt(vt(e,r),r)];let o=Pe,a=Pe;for(let d=0;d<3+db;d++){let f=dm(i,t,e);if(d>=3&&Math.abs(f.x)<um&&Math.abs(f.e)<um)break;let p=st(i,t),x=Tt(e,p),m=Nt(ne(e,p),x);o=vt(st(o,m),.5),e=vt(Nt(Hn(x),e),.25),[i,t]=[vt(Tt(i,t),.5),Re(p)],a=Tt(a,o)}let{x:c,e:l,middle:h}=dm(i,t,e),u=.5*o[0]*l;return a=Tt(a,[u+u*(.25*(l*l-.5*c*c)),0]),{mean:vt(Tt(h,[-.25*h[0]*c*c,0]),s),total:a}}function Ko(i,t){let e=1+Math.sqrt(t),n=.5/((1+t)*e*e),s=n*i,r=s*s*(s*s);return n*(1+r*(2+r*(15+r*(150+r*1707))))}var jo=i=>2*(i+i**4+i**9),fb=20;function fm(i,t){let[e,n,s]=[i,t,Pe];for(let d=0;d<fb;d++){let[f,p,x]=[Re(e),Re(n),Re(s)],m=Tt(Tt(st(f,p),st(p,x)),st(x,f));[e,n,s]=[e,n,s].map(g=>vt(Tt(g,m),.25))}let r=Nt(Tt(Tt(e,n),s),[3,0]),[o,a]=[e,n].map(d=>ne(Pe,Nt(d,r))[0]),c=-o-a,l=o*a-c*c,h=o*a*c,u=-l/10+h/14+l*l/24-3*l*h/44;return Nt(Tt(Pe,We(u)),Re(r))}function pm(i){let{A:t,B:e,C:n,P:s,Q:r,G2:o,moments:a,canonical:c,longAxis:l,rootS:h}=i,u=st(e,r),[d,,f]=c,p=!(u[0]>0)||!(i.rootP>0)||d===0&&f===0,x=!(n[0]>0&&h[0]>0)&&!p,m=Re(o),g=Re(u),y={modulus:g,mean:Pe,precession:fn,G:m,constant:p,separatrix:x};if(p)return y;let[S,v,A]=a,w=l?-1:1;if(x)return{...y,precession:st(m,Te(w*S,A))};let _=e[0]>=t[0],M=_?st(r,n):st(st(e,n),o),{mean:C,total:T}=Jo(g,st(Re(n),h),M),L=Te(w*(l===_?S:A),v),N=st(_?t:s,T),F=_?vt(N,-.5):vt(Nt(N,o),.5),P=st(m,Tt(L,F));return{...y,mean:C,precession:_?P:Tt(P,C)}}var pb=2**-900,mb=100,gb=1e-280;function mm(i,t){let e=[0,1,2].sort((j,W)=>i[j]-i[W]||j-W),[n,s,r]=e,o=(s-n)*(r-n)*(r-s)>0?1:-1,a=t.map(Math.abs),c=Math.max(...a),l=Math.min(...a.map(j=>j===0?c:j)),h=Ye(i[r]),u=Ye(c)-(l<pb*c?mb:0),d=e.map(j=>he(i[j],-h)),f=e.map(j=>o*he(t[j],-u)),[p,x,m,g,y,S]=xb(d,f),v=Ye(Math.max(Math.abs(f[0]),Math.abs(f[2]))),A=[he(f[0],-v),f[1],he(f[2],-v)],w=_b(d,A,p,x),_=w[0]>0,M=_?w:fi(w),[C,T]=_?[f[2],f[0]]:[f[0],f[2]],L=T<0?-1:1,N=[L,1,L],F=_?[r,s,n]:e,P=he(1,v),[B,G,H]=_?[x,p,y]:[p,x,g];return{moments:d,momentum:f,canonical:[C*L,f[1],T*L],A:B,B:G,C:m,P:H,Q:_?g:y,S:vt(vt(M,-P),P),rootS:vt(Re(M),P),rootP:yb(H[0],m[0],C,G[0],f[1]),V:Vn(Te(d[0],d[1]),d[2]),G2:S,longAxis:_,axes:[0,1,2].map(j=>[0,1,2].map(W=>F[W]===j?o*N[W]:0)),momentumScale:he(1,u),rateScale:he(1,u-h)}}function xb(i,t){let e=Vn(ze(i[1],-i[0]),i[2]),n=Vn(ze(i[2],-i[1]),i[0]),s=Vn(ze(i[2],-i[0]),i[1]),[r,o,a]=t.map(h=>Te(h,h)),c=Tt(st(s,r),st(n,o)),l=Tt(st(e,o),st(s,a));return[e,n,s,c,l,Tt(Tt(r,o),a)]}function _b(i,t,e,n){let s=st(e,Te(t[0],t[0])),r=ne(s,st(n,Te(t[2],t[2])));if(!(Math.abs(r[0])<.01*s[0]))return r;let o=ze(i[1],-i[0]),a=ze(i[2],-i[1]);for(let c of[i[2],t[0],t[0]])o=Ml(o,c);for(let c of[-i[0],t[2],t[2]])a=Ml(a,c);return wr([...o,...a])}function yb(i,t,e,n,s){if(i>gb)return Math.sqrt(i);let r=Ye(Math.max(Math.abs(e),Math.abs(s))),[o,a]=[e,s].map(c=>he(c,-r));return he(Math.sqrt(t*o*o+n*a*a),r)}function mi([i,t]){let e=Fi(i);return[e,i-e,t]}function ps(i,t,e,n){let s=i[0]*t,r=i[0]*e,o=i[1]*t,a=Math.round(s),c=Math.round(r),l=Math.round(o),h=i[1]*e+i[2]*(t+e),u=r-c,d=o-l,f=u+d,p=f-u,x=u-(f-p)+(d-p),m=s-a,g=m+f,y=g-m,S=m-(g-y)+(f-y),v=Math.round(g);n[0]=g-v,n[1]=S+(x+h),n[2]=a+(c+l)+v}function ms(i,t){let e=Math.tan(i*Math.PI),n=2/(e*e+1);t[0]=e*n,t[1]=n-1}function Or(i,t,e,n){let s=Fi(i),r=i-s,o=s*n+r*(e+n)+t*e;return Math.exp(-(s*e))*(1-o*(1-.5*o))}var si=i=>i-Math.round(i);var gm=[2**-400,2**-200],vb=[138.62943611198907,-33555121496085278e-31],[Fr,gs,zi,vn]=[3,3,2,4].map(i=>new Float64Array(i));function xm(i,t,e){let{constant:n,separatrix:s}=t,r=i.A[0]*i.P[0],o=-i.C[0]*i.S[0],a=n||r<=o&&!s,c=vt(Nt(Go,i.V),i.rateScale),l=vt(st(t.precession,c),.5),h=vt(st(t.mean,c),2),u=vt(h,.25),d=vt(Nt(t.modulus,i.V),i.rateScale),f=a?ne(l,u):l,p=a?Tt(l,u):s?d:h;n&&([f,p]=[Mb(i),fn]);let m={...n?Sb():a?bb(i,r,o):wb(i,t,r,o),full:a,first:mi(f),second:mi(p)};return{...m,...Ab(m,i,t,e)}}function Mb(i){let[t,e,n]=i.momentum.map((r,o)=>Hn(Nt(We(r),We(i.moments[o])))),s=st(Re(Tt(Tt(t,e),n)),Go);return vt(s,.5*i.rateScale)}var Sb=()=>({start:0,a:[1,0,0,0,0],b:[0,0,0,0,0]});function _m(i,t,e,n,s){let[r,o,a,c]=[1,i,1,e];for(let l=0;l<5;l++){let h=(r-o)/(r+o);[r,o]=[.5*(r+o),Math.sqrt(r*o)];let u=1+h,d=Math.sqrt(1-h*(1-t)/(1+t));a*=d/u,c=2*c/(u*(n+s)),s=Math.sqrt(1+h*(s-n)/(s+n)),[n,t]=[1,d]}return[a,c]}function bb(i,t,e){let[n,s,r,o]=[i.A[0],i.B[0],i.C[0],i.Q[0]],[a,c,l]=i.canonical,h=s*o,u=Ko(t/h,Math.sqrt(e/h)),d=u*(t/h),f=i.rootP/Math.sqrt(o),[p,x]=_m(Math.sqrt(e/h),l*Math.sqrt(r/o),Math.sqrt(s),Math.sqrt(s),Math.sqrt(r)),m=x+Math.sqrt(f*f+x*x),g=f/m,y=n/s*u*m*m,S=Math.atan2(Math.sqrt(s)*c*p,Math.sqrt(r)*a)*(.25/Math.PI),v=g*g,A=d*d,w=A*A,_=w*w,[M,C]=[-d*v,-A*y],[T,L]=[w*A*v*v,_*y*y],N=T+L,F=[1-N,M+C,2*N,M-C,2*(T-L)];[M,T,L]=[-A*d*v,_*A*v*v,w*y*y],N=T+L;let P=[g*(1-N),g*(M-y),2*g*N,g*(M+y),2*g*(T-L)];return{start:S,a:F,b:P}}function wb(i,t,e,n){let[s,r,o,a,c]=[i.B[0],i.C[0],i.P[0],i.Q[0],t.G[0]],[l,h,u]=i.canonical,{separatrix:d}=t,f=d?1:Math.sqrt(e/(s*a)),p=d?0:n/(s*a),x=p*Ko(p,f),m=Math.sqrt(r)*Math.abs(l),g=Math.sqrt(r)*u*Math.sqrt(o/a),y=Math.abs(Math.sqrt(s)*h),S=m+g<gm[0]*y,[v,A]=_m(f,Math.sqrt(o/s)/c,S?gm[1]*y:y,m,g),w=Math.atan(Math.sqrt(a/o)*v),_=S?Math.log(2*A):Math.asinh(A),M=S?.5*Math.exp(_):Math.sinh(_),C=Bi(_,(A-M)/(S?M:Math.sqrt(1+M*M)));S&&(C=Tt(C,vb)),C=vt(C,h<0!=l<0?-1:1);let T=Pe;if(!d){let B=jo(x);T=Nt(st(t.modulus,yn),t.mean),T=Tt(T,[-T[0]*(B*(2+B)/((1+B)*(1+B))),0])}let L=[0,1,2,3,4].map(B=>(2*B+1)*(.5*w-.25*Math.PI)),[N,F,P]=mi(T);return{start:Nt(C,T),cosines:L.map(Math.cos),sines:L.map(Math.sin),rootNome:Math.sqrt(x),decay:[N,F+P],yTurns:d?0:w*(.5/Math.PI),periodic:d?0:1,parity:l<0?1:0}}function Ab(i,t,e,{moments:n,momentum:s,attitude:r}){let{constant:o}=e;ym(i,0,0);let a=Math.sqrt(vn.reduce((y,S)=>y+S*S,0)),[c,l,h,u]=vn.map(y=>y/a),d=[[c,l,h,u],[-u,h,-l,c],[h,u,-c,-l],[-l,c,u,-h]],f=t.longAxis?-1:1,p=Eb(n,s),x=[0,1,2,3].map(y=>{if(o)return Nu(r,[y===0?1:0,...p.map(v=>y===1?v:0)]);let S=t.axes.map(v=>f*v.reduce((A,w,_)=>A+w*d[1+_][y],0));return Nu(r,[d[0][y],...S])}),m=e.G[0]*t.momentumScale,g=o?s.flatMap(y=>[0,0,y]):t.axes.flat().map(y=>m*y);return{toAttitude:[0,1,2,3].flatMap(y=>x.map(S=>S[y])),toMomentum:g}}function Eb(i,t){let e=Math.max(...t.map(Math.abs));if(!(e>0))return[0,0,0];let n=Math.min(...i),s=t.map((o,a)=>o/e*(n/i[a])),r=Math.sqrt(s.reduce((o,a)=>o+a*a,0));return s.map(o=>r>0?o/r:0)}function ym(i,t,e){i.full?Tb(i,t,e):Rb(i,t,e)}function Tb(i,t,e){let{a:n,b:s,start:r}=i;ps(i.first,t,e,Fr),ps(i.second,t,e,gs),ms(si(Fr[0]+(Fr[1]-r)),zi);let o=zi[0],a=zi[1];ms(si(gs[0]+(gs[1]+r)),zi);let c=zi[0],l=zi[1],h=a*l+o*c,u=c*a-l*o,d=u+u,f=1-d*u,p=d*h,x=n[0]+f*(n[1]+f*n[2]),m=p*(n[3]+f*n[4]),g=s[0]+f*(s[1]+f*s[2]),y=p*(s[3]+f*s[4]);vn[0]=a*x-o*m,vn[1]=a*m+o*x,vn[2]=l*g-c*y,vn[3]=l*y+c*g}function Rb(i,t,e){let{start:n,periodic:s,decay:r,cosines:o,sines:a,rootNome:c}=i;ps(i.first,t,e,Fr),ps(i.second,t,e,gs);let l=(1-s)*gs[2],[h,u]=ze(l,gs[0]),[d,f]=ze(h,n[0]),[p,x]=Bi(d,gs[1]+(n[1]+(u+f))),m=s*Math.round(p),g=p-m,y=i.parity+(s*gs[2]+m);y-=4*Math.round(.25*y);let S=si(Fr[0]-.25*y)+(Fr[1]-g*i.yTurns),v=g<0?-1:1,A=g*v,w=x*v,_=Or(A,w,r[0],r[1]),M=Math.max(.5-A,0),C=s*Or(M,(.5-M-A)*s-w,r[0],r[1]);ms(si(S),zi);let T=c*c,L=T*T,N=1,F=_,P=c*C,B=T*_,[G,H,j,W,Y]=[0,0,0,0,-1];for(let X=0;X<5;X++){let rt=N+F,xt=N-F;G+=o[X]*rt,H+=a[X]*xt,j+=Y*a[X]*rt,W-=Y*o[X]*xt,N*=P,F*=B,P*=T,B*=T,Y=-Y}H*=v,W*=v;let tt=1-2*(y-2*Math.floor(.5*y)),gt=zi[0],wt=zi[1];vn[0]=wt*G-gt*H,vn[1]=wt*H+gt*G,vn[2]=tt*(wt*j-gt*W),vn[3]=tt*(wt*W+gt*j)}function vm(i,t,e){ym(i,t,e);let[n,s,r,o]=[vn[0],vn[1],vn[2],vn[3]],a=n*n+s*s,c=r*r+o*o,l=1/(a+c),h=Math.sqrt(l),u=(n*r+s*o)*(l+l),d=(n*o-s*r)*(l+l),f=(a-c)*l,[p,x]=[i.toAttitude,i.toMomentum],[m,g,y,S]=[n*h,s*h,r*h,o*h],v=w=>p[w]*m+p[w+1]*g+p[w+2]*y+p[w+3]*S,A=w=>x[w]*u+x[w+1]*d+x[w+2]*f;return{attitude:[v(0),v(4),v(8),v(12)],momentum:[A(0),A(3),A(6)]}}var Cb=1e-14,ki=class{constructor({moments:t,momentum:e,attitude:n=[1,0,0,0],epoch:s=0}){this.moments=Ar(t),this.momentumAtEpoch=pn("momentum",e,3,"kg m\xB2/s"),this.attitudeAtEpoch=Tr(Er(n)),this.epoch=Se("epoch",s,"seconds");let r={moments:this.moments,momentum:this.momentumAtEpoch,attitude:this.attitudeAtEpoch},o=mm(r.moments,r.momentum),a=pm(o);this._fastest=Math.max(...r.momentum.map((d,f)=>Math.abs(d/r.moments[f]))),this._motion=xm(o,a,r);let{first:c,second:l,toAttitude:h,toMomentum:u}=this._motion;Al([this._fastest,...c,...l,...h,...u]),this._curve={body:o,rates:a},this.energy=.5*r.momentum.reduce((d,f,p)=>d+f/r.moments[p]*f,0),this.momentumNorm=Math.hypot(...r.momentum),Object.assign(this,Pb(r,o,a))}state(t){let[e,n]=wl(t,this.epoch,this._fastest),s=Fi(e);return vm(this._motion,s,e-s+n)}angularVelocity(t){let e=this.state(t).momentum;return[e[0]/this.moments[0],e[1]/this.moments[1],e[2]/this.moments[2]]}along(t){let{body:e,rates:n}=this._curve,s=this.momentumAtEpoch;if(n.constant)return Array.from({length:t},()=>[...s]);let[r,o,a,c,l]=[e.A,e.B,e.C,e.P,e.Q].map(y=>y[0]),h=o*l,[u,d]=n.separatrix?[1,0]:[r*c/h,-a*e.S[0]/h],[f,p]=e.canonical,x=e.rootP,m=Math.atan2(Math.sqrt(o)*p,Math.sqrt(a)*f),g=n.separatrix&&f<0?-1:1;return Array.from({length:t},(y,S)=>{let v=n.separatrix?Math.PI*(S/Math.max(t-1,1)-.5):m+2*Math.PI*S/t,A=g*Math.cos(v),w=g*Math.sin(v),_=[x/Math.sqrt(a)*A,x/Math.sqrt(o)*w,Math.sqrt(l/a)*Math.sqrt(d+u*A*A)];return e.axes.map(M=>e.momentumScale*(M[0]*_[0]+M[1]*_[1]+M[2]*_[2]))})}};function Pb(i,t,e){let n=Ib(i,t,e);if(e.constant)return{regime:n,encircledAxis:null,modulus:null,period:null,precessionRate:null,precessionPerPeriod:null,flipInterval:null,solidAngle:null};let s=t.longAxis?-1:1,r=s*vt(Nt(e.precession,t.V),t.rateScale)[0];if(e.separatrix)return{regime:n,encircledAxis:null,modulus:1,period:1/0,precessionRate:r,precessionPerPeriod:1/0,flipInterval:1/0,solidAngle:null};let o=Nt(vt(yn,2),e.mean),a=st(e.precession,o),c=st(o,t.V)[0]/t.rateScale;return{regime:n,encircledAxis:t.axes.findIndex(l=>l[2]!==0),modulus:Math.sqrt(t.A[0]/t.B[0])*(t.rootP/Math.sqrt(t.Q[0])),period:c,precessionRate:r,precessionPerPeriod:s*a[0],flipInterval:n==="symmetric"?null:.5*c,solidAngle:Lb(t,e,a,o)}}function Ib({moments:i,momentum:t},e,n){let[s,r,o]=e.moments;return t.every(a=>a===0)?"rest":s===o?"spherical":n.constant?"permanent":n.separatrix?"separatrix":s===r||r===o?"symmetric":e.longAxis?"long-axis":"short-axis"}function Lb(i,t,e,n){if(i.A[0]===0){let u=i.C[0]*i.G2[0];return 2*Math.PI*i.P[0]/u/(1+Math.sqrt(i.Q[0]/u))}let[s,r,o]=i.moments;if(i.P[0]/(i.B[0]*i.G2[0])<Cb)return Math.PI*i.P[0]/(Math.sqrt(i.B[0]*i.C[0])*i.G2[0]);let c=Te(i.longAxis?-o:s,r),l=Tt(i.P,st(c,i.G2)),h=st(Nt(l,t.G),n);return ne(vt(yn,2),ne(e,h))[0]}function Sm(i,t){let e=i.momentum[2],n=i.s0[0]===0||i.t0[0]===0,s=i.w2[0]===0&&(n||i.G[0]===0&&e===0),r=!(t.B[0]>0)&&!s,o=i.cPlus[0]>=0?1:-1,a=i.c[0]>=0?1:-1,c=vt(i.cPlus,o),[l,h]=i.moments,u=Nt(Vn(ze(l,-h),e),We(h)),d=Re(t.A),f={halfRoot:vt(d,.5),signAlpha:o,signBeta:a,spin:u,permanent:s,separatrix:r,steady:!1};if(s)return{...f,nutation:fn,alpha:fn,beta:fn};if(r)return{...f,nutation:fn,alpha:vt(c,.25*o),beta:fn};let p=Db(i,t,d,c,vt(i.c,a)),x={nutation:p.nutation,alpha:vt(p.alpha,o),beta:vt(p.beta,a)};return{...f,...i.leaves?Nb(i,f.halfRoot,x):x,steady:!(t.d[0]>0)}}var $u=i=>i.leaves?Vn(Fp,i.lift):fn;function Nb(i,t,{nutation:e,alpha:n,beta:s}){let r=vt(i.cPlus,.25),o=vt(Nt(st($u(i),e),st(yn,t)),2),a=Nt(Pe,Tt(Pe,o));return{nutation:st(e,a),alpha:Tt(r,st(ne(n,r),a)),beta:st(s,a)}}function Db(i,t,e,n,s){let{G:r}=i,{A:o,B:a,s1:c,s2:l,t1:h,t2:u,d,zMinus:f,zPlus:p}=t,x=Re(a),m=p[0]<=2*o[0],g=st(r,l)[0]<=f[0],y=m?p:Nt(st(o,u),h),v=g&&s[0]===0?o:g?f:Nt(st(c,a),l),A=Jo(e,x,y),w=Jo(e,x,v),_=vt(A.mean,.5),M=Mm(r,n,p,h,u,d,_,A.total,m),C=Mm(r,s,f,l,c,d,_,w.total,g);return{nutation:_,alpha:M,beta:g?fi(C):C}}function Mm(i,t,e,n,s,r,o,a,c){let l=t[0]===0;if(c)return vt(st(Nt(st(t,i),l?Pe:e),a),.25);let h=vt(Nt(t,l?Pe:n),.5),u=vt(st(Nt(r,s),a),.5);return ne(st(h,ne(Pe,u)),o)}var[Ub,Ob]=[-200,-150];function bm(i,t,e,n){let s=t<0,r=s?[-n[1],n[0],n[3],-n[2]]:[...n],[o,a,c,l]=r,h=s?-1:1,u=Ye(i[0]),d=Bb(i[0],Math.abs(t),e),[f,p]=[i[0],i[2]].map(G=>he(G,-u)),x=[e[0],h*e[1],h*e[2]],m=x.map(G=>he(G,-d)),g=he(Math.abs(t),u-d),y=he(g,-d),S=vt(Te(y,f),2),v=Sl([...Ul(a,c),...Ul(o,l)]),{below:A,lift:w,kept:_}=Fb(S,m,r),C=[...[0,1].map(G=>_*he(x[G],w-d)),m[2]],[T,L]=A?[0,w]:[w,0],[N,F]=[a,c].map(G=>_*he(G,T)),P=[he(o,L),N,F,he(l,L)],B=zb(S,v,C,P);return{moments:[f,p],momentum:C,quaternion:P,...B,reversed:s?-1:1,lift:w,upright:!A,leaves:w>0&&!A&&B.D[0]>0,momentumScale:he(1,d),rateScale:he(1,d-u)}}var Ul=(i,t)=>Sl([...Te(i,i),...Te(t,t)]);function Fb(i,[t,e,n],[s,r,o,a]){let c=(y,S)=>Math.max(Math.abs(y),Math.abs(S)),[l,h]=[c(s,a),c(r,o)],u=l<h,d=Math.max(Math.min(l,h),c(t,e)),f=Ye(d),[p,x]=[vt(i,2),Te(n,n)],m=!u&&p[0]===x[0]&&p[1]===x[1],g=d>0&&f<Ub&&i[0]>0;return{below:u,lift:g&&!m?Ob-f:0,kept:g&&m?0:1}}function Bb(i,t,e){let n=Math.max(...e.map(Math.abs)),s=Ye(n);if(!(t>0))return s;let r=Math.floor((Ye(i)+Ye(t)+1)/2);return n>0?Math.max(s,r):r}function zb(i,t,[e,n,s],[r,o,a,c]){let l=Te,h=Bp,u=Sl,d=F=>F.map(P=>-P),f=Ul(o,a),p=Ul(r,c),x=u([...l(o,r),...l(a,c)]),m=u([...l(o,c),...l(-a,r)]),g=u([...h(x,[e]),...h(m,[-n])]),y=u([...h(x,[n]),...h(m,[e])].map(F=>2*F)),S=u([...y,...h(f,[-2*s])]),v=u([...y,...h(p,[2*s])]),A=[...l(e,e),...l(n,n)],w=u([...h(t,A),...h(i.map(F=>-2*F),f)],5),_=u([...w,...h(S,[-s])],5),M=[...i.map(F=>2*F),...l(s,-s)],C=u([...h(t,M),...d(w)],5),T=u([...h(w,[s]),...h(d(i),S)],6),L=wr(t),N=F=>Nt(wr(F),L);return{size:L,G:i,s0:vt(N(f),2),t0:vt(N(p),2),u0:N([...p,...d(f)]),p:vt(N(g),-2),c:N(S),cPlus:N(v),twist:N(y),F:N(_),D:N(C),w2:wr(A),lean:N(T)}}var kb=-400,Gb=5;function Em(i){let{G:t}=i,e=Hn(i.p),n=Hn(i.c),s=We(i.momentum[2]),r=ne(vt(st(s,i.twist),2),st(t,st(i.s0,i.t0)));r=ne(r,vt(st(i.u0,i.w2),2));let a=[ne(ne(vt(st(t,i.u0),2),i.w2),Hn(s)),st(t,r),st(Hn(t),e)],{root:c,cosine:l}=wm(a),h;if(l>=0||!(t[0]>0))h=Vb(i,e,n,r,Am(c,a));else{let f=[fi(Nt(i.D,t)),vt(Nt(i.F,t),-2),Nt(n,t)];h=Hb(i,e,n,Am(wm(f).root,f))}let u=Tt(i.t0,h.fromUpper),d=Tt(h.Y,st(t,i.t0));return{...h,t2:u,zPlus:d,t1:ri(Hn(i.cPlus),st(u,d))}}function wm([[i],[t],[e]]){let n=t-i*i/3,s=2*i**3/27-i*t/3+e,r=Math.sqrt(Math.max(-n/3,0)),o=r>0?Math.min(Math.max(-.5*s/r**3,-1),1):1;return{root:2*r*Math.cos(Math.acos(o)/3)-i/3,cosine:o}}function Am(i,[t,e,n]){let s=We(i);for(let r=0;r<Gb;r++){let o=Tt(st(Tt(st(Tt(s,t),s),e),s),n),a=Tt(st(Tt(Tt(vt(s,2),s),vt(t,2)),s),e),c=Nt(o,a);Number.isFinite(c[0])&&(s=ne(s,c))}return s}var ri=(i,t)=>i[0]===0?i:Nt(i,t);function Tm(i,t){let e=Ye(i[0]),n=t[0]===0||Ye(t[0])<2*e,s=i[0]!==0&&e<kb&&n?-e:0,r=he(1,s),o=vt(vt(t,r),r),a=Re(Tt(Hn(vt(i,r)),vt(o,4)));return vt(a,he(1,-s))}function Rm(i,t,e){let n=i[0]>=0,s=vt(Tt(t,n?i:fi(i)),.5),r=s[0]>0?ri(e,s):fn;return n?[s,r]:[r,s]}function Vb(i,t,e,n,s){let{G:r}=i,o=ri(t,s),a=ri(Tt(n,st(r,o)),s),c=Tm(a,o),[l,h]=Rm(a,c,o),u=Tt(i.s0,h),d=ne(i.s0,l),f=ne(s,st(r,i.s0));f[0]>=st(r,d)[0]?d=ri(e,st(u,f)):f=ri(e,st(u,d));let p=Tt(s,st(r,h)),x=ne(s,st(r,l));return{fromLower:h,fromUpper:l,d:c,s1:u,s2:d,A:p,B:x,Y:s,zMinus:f}}function Hb(i,t,e,n){let{G:s}=i,r=st(s,n),o=ri(e,r),a=Nt(Tt(vt(i.F,-2),ri(e,n)),r),c=Tm(a,o),[l,h]=Rm(a,c,o),u=st(s,h),d=Tt(st(s,i.s0),u),f=ri(t,d),p=ne(i.s0,l),x=ne(n,i.s0);p[0]>=x[0]?x=ri(f,p):p=ri(f,x);let m=st(s,Tt(n,h));return{fromLower:x,fromUpper:p,d:ne(n,l),s1:n,s2:l,A:m,B:st(s,c),Y:d,zMinus:u}}var[xs,Pn,Ie]=[3,2,10].map(i=>new Float64Array(i));function Cm(i){return Pm(i,0,0),[...Ie]}function Pm(i,t,e){i.full?Wb(i,t,e):qb(i,t,e)}function Qo(i,t,e){return ps(i,t,e,xs),xs[0]+xs[1]}function Wb(i,t,e){let{aSum:n,aGap:s,bSum:r,bGap:o}=i.series;ms(si(Qo(i.third,t,e)+i.start[0]),Pn);let a=Pn[0],c=Pn[1],l=1-2*a*a,h=2*a*c,[u,d,f,p,x,m,g,y]=[0,0,0,0,0,0,0,0];for(let w=0;w<4;w++){let _=2*w+1;u+=n[w]*a,d+=s[w]*c,f+=r[w]*c,p+=o[w]*a,x+=_*n[w]*c,m+=_*s[w]*a,g+=_*r[w]*a,y+=_*o[w]*c;let M=c*l-a*h;a=a*l+c*h,c=M}let[S,v]=i.signs,A=Qo(i.first,t,e);Im(u,-S*d,f,v*p,x,S*m,-g,v*y,A,Qo(i.second,t,e))}function Im(i,t,e,n,s,r,o,a,c,l){Ie[0]=i,Ie[1]=t,Ie[2]=e,Ie[3]=n,Ie[4]=s,Ie[5]=r,Ie[6]=o,Ie[7]=a,Ie[8]=c,Ie[9]=l}function qb(i,t,e){let{start:n,periodic:s,decay:r,q:o,poleTurns:a,signs:c}=i,{aSine:l,aCosine:h,bCosine:u,bSine:d,constant:f}=i.series;ps(i.third,t,e,xs);let[p,x]=ze((1-s)*xs[2],xs[0]),[m,g]=ze(p,n[0]),[y,S]=Bi(m,xs[1]+(n[1]+(x+g))),v=s*Math.round(y),A=y-v,w=s*xs[2]+v,_=.5*(w-2*Math.floor(.5*w)),M=A<0?-1:1,C=A*M,T=S*M,L=Or(C,T,r[0],r[1]),N=Math.max(.5-C,0),F=s*Or(N,(.5-N-C)*s-T,r[0],r[1]),P=L*L,B=F*F,[G,H,j,W,Y,tt,gt,wt]=[0,0,f,0,0,0,0,0],X=1,rt=P,xt=B,At=o*P,pt=o*B,[Dt,fe]=[o*o*B,o*o*o*P];for(let ie=0;ie<4;ie++){let[pe,Mn]=[2*ie+1,2*ie+2],Ce=X*(1+rt),rn=X*(1-rt);G+=l[ie]*Ce,H+=h[ie]*rn,Y+=pe*l[ie]*rn,tt+=pe*h[ie]*Ce,j+=u[ie]*(xt+At),W+=d[ie]*(xt-At),gt+=Mn*u[ie]*(xt-At),wt+=Mn*d[ie]*(xt+At),X*=pt,pt*=o*o,rt*=P*P,xt*=Dt,Dt*=o*o,At*=fe,fe*=o*o}let Rt=2*L,[Yt,jt]=c,kt=A+S,we=si(Qo(i.first,t,e)+Yt*kt*a[0])+_,xe=si(Qo(i.second,t,e)+jt*kt*a[1])+_;Im(G,Yt*M*H,Rt*j,-jt*M*Rt*W,M*Y,Yt*tt,M*Rt*gt,-jt*Rt*wt,we,xe)}function Lm(i,t,e){Pm(i,t,e);let[n,s,r,o]=[Ie[0],Ie[1],Ie[2],Ie[3]],[a,c,l,h]=[Ie[4],Ie[5],Ie[6],Ie[7]],{phases:u,gain:d}=i,f=1/(n*n+s*s+(r*r+o*o)),p=Math.sqrt(f);ms(si(Ie[8]),Pn);let x=Pn[1]*u[0]-Pn[0]*u[1],m=Pn[0]*u[0]+Pn[1]*u[1];ms(si(Ie[9]),Pn);let g=Pn[1]*u[2]-Pn[0]*u[3],y=Pn[0]*u[2]+Pn[1]*u[3],S=(n*x-s*m)*p,v=(n*m+s*x)*p,A=(r*g-o*y)*p,w=(r*y+o*g)*p,_=n*l+s*h-(r*a+o*c),M=n*h-s*l-(o*a-r*c),C=(d[0]*_+d[1]*(s*r-n*o))*f,T=(d[0]*M+d[1]*(n*r+s*o))*f,L=g*x+y*m,N=y*x-g*m,F=[C*L-T*N,i.reversed*(C*N+T*L),i.axial];return{attitude:i.reversed<0?[A,-S,-v,w]:[S,A,w,v],momentum:F}}var Yu=[0,1,2,3];function Nm(i,t,e,n){let s=Xb(i,t,e),{permanent:r,separatrix:o,nutation:a}=e,{full:c,q:l,theta3:h}=s,[u,d]=Zb(i,e).map(A=>Jb(i,A)),f=he(1,i.leaves?0:-i.lift),p=i.upright?[1,f]:[f,1],m=r?jb(i):(c?Qb:tw)(t,s,p),g=r?0:c?a[0]:e.halfRoot[0]/(h*h),y=Kb(e,s),S=2*(y[0]+y[1]),v={full:c,first:mi(u),second:mi(d),...Yb(i,e,s),series:m,q:l,poleTurns:[s.yAlpha,s.yBeta].map(A=>o||c?0:A/Math.PI),periodic:o?0:1,signs:r?[1,1]:[e.signAlpha,e.signBeta],gain:[2*g*i.momentumScale,S*i.momentumScale],axial:n,reversed:i.reversed};return{...v,phases:ew(i,Cm(v),y,g)}}function Xb(i,t,e){let{separatrix:n,permanent:s,steady:r}=e,[o,a,c,l]=[i.G[0],t.d[0],t.A[0],t.B[0]],h=o*a/c,u=n?0:l/c,d=s||h<=u&&!n,f=s?0:d?h:u,p=f*Ko(f,Math.sqrt(1-f)),x=1+jo(p),m=1/(x*x),g={full:d,q:p,theta3:x,yAlpha:0,yBeta:0,rAlpha:0,rBeta:0,x0:fn};if(s)return g;if(r)return{...g,yAlpha:1/0,yBeta:1/0};let y=$b(i,t),S=n?Math.atan2(Math.sqrt(t.t1[0]),Math.sqrt(a)):y.alpha(),v=n||t.s2[0]===0?0:y.beta(),A=w=>d&&p>0?Math.exp(-2*m*w()):0;return{...g,yAlpha:S*m,yBeta:v*m,rAlpha:A(y.beyondAlpha),rBeta:A(y.beyondBeta),x0:vt(Tt(y.start(),$u(i)),i.p[0]>=0?1:-1)}}function $b(i,t){let{G:e}=i,{A:n,B:s,d:r,s1:o,s2:a,t1:c,t2:l,Y:h,zMinus:u,zPlus:d,fromLower:f,fromUpper:p}=t,x=Nt,m=(g,y,S)=>{let v=y[0]+S[0];return st(Re(g),v>0&&Number.isFinite(v)?fm(y,S):Pe)};return{alpha:()=>m(x(c,l),x(r,l),x(st(r,d),st(n,l)))[0],beta:()=>{let g=st(o,s);return m(x(st(a,n),g),x(st(r,u),g),x(r,o))[0]},beyondAlpha:()=>m(x(n,d),x(st(e,c),d),x(st(e,l),d))[0],beyondBeta:()=>m(x(u,s),x(st(e,a),s),x(st(e,o),n))[0],start:()=>m(x(f,r),x(p,r),x(h,n))}}function Yb(i,t,e){let{permanent:n,separatrix:s,halfRoot:r,nutation:o}=t;if(n)return{third:[0,0,0],start:[.25,0],decay:[1,0]};let a=i.moments[0];if(s){let m=Nt(vt(r,i.rateScale),We(a));return{third:mi(m),start:e.x0,decay:[1,0]}}let c=e.full?.5:1,l=Nt(vt(o,i.rateScale),Vn(yn,a)),h=Nt(st(r,yn),o),u=jo(e.q),d=u*(2+u)/(e.theta3*e.theta3),[f,p,x]=mi(Tt(h,[-h[0]*d,0]));return{third:mi(vt(l,c)),start:vt(Nt(e.x0,h),c),decay:[f,p+x]}}function Zb(i,t){let e=vt(t.spin,.5);if(!t.permanent)return[Tt(t.alpha,e),ne(t.beta,e)];let[n,s]=i.moments,r=Nt(Te(.5*i.momentum[2],n),We(s));return[r,fi(r)]}function Jb(i,t){let e=Nt(Go,We(i.moments[0]));return vt(st(t,e),i.rateScale)}function Kb(i,t){if(i.permanent)return[0,0];let e=t.full||i.separatrix,n=(s,r)=>e?0:s*r*i.nutation[0]*(2/Math.PI);return[i.alpha[0]+n(i.signAlpha,t.yAlpha),i.beta[0]+n(i.signBeta,t.yBeta)]}function jb(i){let t=[0,0,0,0],[e,n]=[i.t0[0],i.s0[0]].map(s=>Math.sqrt(.5*s));return{aSum:[e,0,0,0],aGap:t,bSum:t,bGap:[n,0,0,0]}}function Qb(i,{q:t,theta3:e,yAlpha:n,yBeta:s,rAlpha:r,rBeta:o},[a,c]){let l=1-2*(t-t**4+t**9),h=(x,m,g,y)=>{let S=Math.exp(-2*m),v=Yu.map(_=>_?(t**_*g)**_:1),A=v.reduceRight((_,M,C)=>_+M*(1+S**(2*C+1)),0),w=v.map((_,M)=>x/A*(y&&M%2?-1:1)*_);return[1,-1].map(_=>w.map((M,C)=>M*(1+_*S**(2*C+1))))},[u,d]=h(a*Math.sqrt(.5*i.t2[0])*e,n,r,!0),[f,p]=h(c*Math.sqrt(.5*i.s1[0])*l,s,o,!1);return{aSum:u,aGap:d,bSum:f,bGap:p}}function tw(i,{q:t,theta3:e,yAlpha:n,yBeta:s}){let r=h=>1-2*(t*Math.cos(2*h)-t**4*Math.cos(4*h)+t**9*Math.cos(6*h)),o=Math.sqrt(.5*i.t2[0])*e/r(n),a=Math.sqrt(.5*i.s1[0])*(1+t**2+t**6+t**12)/r(s),c=h=>Yu.map(u=>o*(u%2?-1:1)*h((2*u+1)*n)),l=h=>Yu.map(u=>a*(u%2?1:-1)*h((2*u+2)*s));return{aSine:c(Math.sin),aCosine:c(Math.cos),bCosine:l(Math.cos),bSine:l(Math.sin),constant:a}}function ew(i,t,e,n){let[s,r,o]=i.momentum,a=Re(i.size),[c,l,h,u]=i.quaternion.map(G=>Nt(We(G),a)[0]),d=[[c,u],[l,h]],f=[[.5*(-o*u-(s*l+r*h)),.5*(o*c-(s*h-r*l))],[.5*(s*c-r*u+o*h),.5*(s*u+r*c-o*l)]],p=he(1,i.lift),[x,m]=i.upright?[1,p]:[p,1],[g,y,S,v]=[0,1,4,5].map(G=>x*t[G]),[A,w,_,M]=[2,3,6,7].map(G=>m*t[G]),[C,T]=t.slice(8),L=g*g+y*y+(A*A+w*w),N=Math.sqrt(L),F=(g*S+y*v+(A*_+w*M))/L,P=s*s+r*r+o*o+i.G[0]||1;return[[g,y,S,v,C],[A,w,_,M,T]].flatMap(([G,H,j,W,Y],tt)=>{let[gt,wt,X]=[G/N,H/N,e[tt]],rt=n*(j/N-gt*F)-X*wt,xt=n*(W/N-wt*F)+X*gt,[[At,pt],[Dt,fe]]=[d[tt],f[tt]],Rt=gt*At+wt*pt+(rt*Dt+xt*fe)/P,Yt=gt*pt-wt*At+(rt*fe-xt*Dt)/P,[jt,kt]=[Math.cos(2*Math.PI*Y),Math.sin(2*Math.PI*Y)],[we,xe]=[Rt*jt+Yt*kt,Yt*jt-Rt*kt],ie=Math.sqrt(we*we+xe*xe);return ie>0?[we/ie,xe/ie]:[1,0]})}var ta=class{constructor({moments:t,mgl:e,momentum:n,attitude:s=[1,0,0,0],epoch:r=0}){if(this.moments=Ar(t),this.moments[0]!==this.moments[1])throw new RangeError(`\`moments\` must be (I1, I1, I3), the first two equal; got ${JSON.stringify(this.moments)} kg m\xB2. Give one of them twice if they differ by rounding, and put the axis of symmetry third.`);this.mgl=Se("mgl",e,"N m"),this.momentumAtEpoch=pn("momentum",n,3,"kg m\xB2/s"),this.attitudeAtEpoch=Er(s),this.epoch=Se("epoch",r,"seconds");let o=this.momentumAtEpoch,a=bm(this.moments,this.mgl,o,this.attitudeAtEpoch),c=Em(a),l=Sm(a,c),h=Math.max(...o.map((M,C)=>Math.abs(M/this.moments[C])));this._fastest=h+Math.sqrt(Math.abs(this.mgl)/this.moments[0]),this._motion=Nm(a,c,l,o[2]);let{first:u,second:d,third:f,start:p,gain:x,phases:m}=this._motion;Al([this._fastest,...u,...d,...f,...p,...x,...m]);let[g,y,S,v]=this.attitudeAtEpoch,[A,w]=[g*g+v*v,y*y+S*S],_=.5*o.reduce((M,C,T)=>M+C/this.moments[T]*C,0);this.energy=_+this.mgl*(A-w)/(A+w),this.verticalMomentum=Vo(Tr(this.attitudeAtEpoch),o)[2],this.axialMomentum=o[2],Object.assign(this,nw(a,c,l))}state(t){let[e,n]=wl(t,this.epoch,this._fastest),s=Fi(e);return Lm(this._motion,s,e-s+n)}angularVelocity(t){let e=this.state(t).momentum;return[e[0]/this.moments[0],e[1]/this.moments[1],e[2]/this.moments[2]]}};function nw(i,t,e){let{permanent:n,separatrix:s,nutation:r}=e,[o,a]=n?[i.u0[0],i.u0[0]]:[Dm(t.s1,t.t1),Dm(t.s2,t.t2)],c={regime:iw(i,e),nutationLimits:i.reversed<0?[-a,-o]:[o,a],nutationPeriod:s?1/0:null,precessionPerPeriod:null,spinPerPeriod:null,precessionRate:null,spinRate:null};if(n||s)return c;let l=Tt(Nt(e.alpha,r),We(e.signAlpha)),h=Tt(Nt(e.beta,r),We(e.signBeta)),u=Nt(e.spin,r),d=st(yn,Tt(l,h))[0],f=i.reversed*st(yn,Tt(ne(l,h),u))[0],p=Nt(Vn(yn,i.moments[0]),vt(r,i.rateScale))[0];return{...c,nutationPeriod:p,precessionPerPeriod:d,spinPerPeriod:f,precessionRate:d/p,spinRate:f/p}}var Dm=(i,t)=>i[0]<t[0]?ne(Pe,i)[0]:ne(t,Pe)[0];function iw(i,t){let[e,n,s,r]=[i.momentum[2],i.c[0],i.cPlus[0],i.lean[0]];if(t.permanent&&e===0)return"rest";if(i.G[0]===0)return"free";if(t.permanent)return i.s0[0]===0?"sleeping":"hanging";if(t.separatrix)return"separatrix";if(t.steady)return"steady";if(e===0&&n===0)return"planar";let o=e<0?-r:r,a=n*e<0&&s*e>0;return a&&o===0?"cusp":a&&o>0?"loop":"undulating"}var Um=Math.PI/180,[sw,rw,ow]=[45,60,20],Ju="turns over and over",aw=.995,cw=!0,lw=["spin.tilt","spin.rate","spin.about"],hw={body:{moments:3},spin:cs};function uw({moments:i,momentum:t,attitude:e=[1,0,0,0],epoch:n=0,mass:s}){let r=t.map((a,c)=>a/i[c]),o=ls(r);return{moments:i,velocity:r,attitude:e,epoch:n,about:o,around:Ze(r,o).around,momentum:t,mass:s??1}}function dw(i){let t=Om(i);return[...t?[{key:"by",label:"set the body by",value:i.by??0,choices:[[0,"its moments"],[1,"the edges of a box"]]}]:[],...t&&i.by?fw(i,t):hs(i.moments),...us(i)]}function fw({mass:i=1},t){let e=Math.max(...t),[n,s]=[["km",1e3],["m",1],["cm",.01],["mm",.001],["\xB5m",1e-6],["nm",1e-9]].find(([,r])=>e>=r)??["m",1];return[{key:"mass",label:"mass of the box",unit:"kg",value:i,log:!0,low:i/20,high:20*i},...t.map((r,o)=>({key:`edge.${o}`,label:`edge along axis ${o+1}`,unit:n,si:s,value:r,log:!0,low:Math.max(r,.001*e)/10,high:10*Math.max(r,.001*e)}))]}function Om({moments:i,mass:t=1}){let e=i[0]+i[1]+i[2],n=i.map(s=>6/t*(e-2*s));return n.every(s=>s>=0&&Number.isFinite(s))?n.map(Math.sqrt):null}function pw(i,t,e){let[n,s]=t.split(".");if(n==="by")return{...i,by:e};if(n!=="edge"&&n!=="mass")return ds(i,t,e);let r=Om(i),o=n==="mass"?e:i.mass??1;n==="edge"&&(r[Number(s)]=e);let a=r.map(l=>l*l),c=[0,1,2].map(l=>o/12*(a[(l+1)%3]+a[(l+2)%3]));return{...i,mass:o,moments:c,momentum:null}}function mw(i,t){let e=Math.hypot(...i.velocity.map((r,o)=>r*i.moments[o])),n=t.map(r=>r*e),s=n.map((r,o)=>r/i.moments[o]);return{...i,velocity:s,momentum:n,around:Ze(s,i.about).around}}var gw=i=>new ki({moments:i.moments,momentum:qn(i),attitude:i.attitude,epoch:i.epoch});function xw({moments:i,velocity:t,attitude:e}){return{body:{moments:i},spin:{angular_velocity:t,attitude:e}}}var _w=(i,t)=>fs(i,t);function yw({moments:i,velocity:t,attitude:e},n){return`[body]
moments = ${Cn(i,"kg*m^2")}

[spin]
angular_velocity = ${Cn(t,"rad/s")}
attitude = [${e.map(Vt).join(", ")}]

[time]
until = "${Vt(n)} s"
`}function vw({moments:i,velocity:t},e){let n=Wn(i),{period:s,regime:r}=e,o=s!==null&&Number.isFinite(s),a=Fm(i,t,e,n),c=[["what it does",a]];return o&&c.push(["period of L in the body",ii(s,s)]),o&&e.precessionPerPeriod!==null&&c.push(["precession about L",`${$t(e.precessionPerPeriod/Um,5)}\xB0 per period`]),a===Ju&&Number.isFinite(e.flipInterval??NaN)&&c.push(["turns over every",ii(e.flipInterval,e.flipInterval)]),c.push(["regime",r]),c}function Mw({moments:i,velocity:t},e){let{period:n,flipInterval:s}=e;return n===null||!Number.isFinite(n)?null:Fm(i,t,e,Wn(i))===Ju?s:n}function Fm(i,t,{regime:e,modulus:n},s){if(e==="rest")return"at rest";if(e==="separatrix")return"runs up to the intermediate axis and stays there";if(e==="permanent"||e==="spherical")return"spins steadily";let[r,o]=Sw(i,t,s),c=Number(r.toPrecision(3))===Number(o.toPrecision(3))?Zu(o):`${Zu(r)} to ${Zu(o)}`;return o<sw?`cones, its axis ${c} from L`:o>=rw&&(o-r>=ow||n>aw)?Ju:`tumbles, its axis ${c} from L`}function Zu(i){let[t,e]=[[1,"\xB0"],[.016666666666666666,"\u2032"],[.0002777777777777778,"\u2033"],[27777777777777776e-23," mas"]].find(([n])=>i>=n)??[1,"\xB0"];return`${$t(i/t,3)}${e}`}function Sw(i,t,e){let[n,s,r]=e.map(m=>i[m]),o=e.map(m=>t[m]*i[m]),a=Math.hypot(...o),[c,l,h]=o.map(m=>Math.abs(m)/a),u=n===r||n*(r-s)*h*h>=r*(s-n)*c*c,d=u?n*(r-s)/(s*(r-n)):r*(s-n)/(s*(r-n)),f=u?c:h,p=Math.sqrt(f*f+(d||0)*l*l),x=Math.min(1,d>0?p/Math.sqrt(d):1);return n===r?[0,0]:[Math.asin(Math.min(p,x)),Math.asin(Math.max(p,x))].map(m=>m/Um)}var ju={};qi(ju,{asSpec:()=>Iw,changed:()=>Cw,controls:()=>Rw,facts:()=>Dw,first:()=>ww,from:()=>Ew,kept:()=>Bl,keys:()=>Aw,make:()=>Pw,toml:()=>Nw,withSpec:()=>Lw});var bw=Math.PI/30,ww=["rate","rotor","spin.tilt","spin.rate"],Aw={body:{moments:3},system:{kind:0,rotor_axis:3,rotor_moment:1,rotor_rate:1,rotor_drive:0,rotor_momentum:1},spin:cs};function Ew({moments:i,rotor:t,rotor_moment:e=null,rotor_drive:n="constant-rate",momentum:s,attitude:r=[1,0,0,0],epoch:o=0}){let a=s.map((d,f)=>(d-t[f])/i[f]),c=ls(a),l=Math.hypot(...t),h=l>0?t.map(d=>d/l):[0,0,1],u=Ze(a,c).around;return{moments:i,velocity:a,attitude:r,epoch:o,about:c,around:u,momentum:s,axis:h,spin:l,moment:e,drive:n}}var Tw={momentum_space:"L in space"},Ol=({axis:i,spin:t})=>i.map(e=>e*t),Bm=({axis:i,drive:t,velocity:e})=>t==="free"?i.reduce((n,s,r)=>n+s*e[r],0):0,Fl=i=>i.spin/i.moment-Bm(i),zm=(i,t)=>({...i,spin:i.moment*(t+Bm(i)),momentum:null});function Rw(i){let t=Math.max(Math.abs(i.spin),Math.hypot(...qn(i,Ol(i))))||1;return[i.moment===null?{key:"rotor",label:"momentum of the rotor",unit:"kg m\xB2/s",value:i.spin,low:-2*t,high:2*t}:{key:"rate",label:"rotor speed against the body",unit:"rpm",si:bw,value:Fl(i),low:-2*t/i.moment,high:2*t/i.moment},...hs(i.moments),...us(i)]}function Cw(i,t,e){return t==="rotor"?{...i,spin:e,momentum:null}:t==="rate"?zm(i,e):ds(i,t,e)}var Pw=i=>new qo({moments:i.moments,rotor:Ol(i),rotor_moment:i.moment,rotor_drive:i.drive,axis:i.axis,momentum:qn(i,Ol(i)),attitude:i.attitude,epoch:i.epoch}),Iw=i=>({body:{moments:i.moments},system:i.moment===null?{kind:"gyrostat",rotor_axis:i.axis,rotor_momentum:i.spin}:{kind:"gyrostat",rotor_axis:i.axis,rotor_moment:i.moment,rotor_rate:Fl(i),rotor_drive:i.drive},spin:{angular_velocity:i.velocity,attitude:i.attitude}});function Lw(i,t){let{system:e={}}=t,n={...i};if(e.rotor_axis){let o=Math.hypot(...e.rotor_axis);if(!(o>0))throw new RangeError("system.rotor_axis must have a direction; got zeros.");Object.assign(n,{axis:e.rotor_axis.map(a=>a/o),momentum:null})}let s=e.rotor_rate??(n.moment===null?null:Fl(n));if(e.rotor_moment!==void 0&&Object.assign(n,{moment:e.rotor_moment,momentum:null}),e.rotor_drive!==void 0&&Object.assign(n,{drive:e.rotor_drive,momentum:null}),e.rotor_momentum!==void 0&&Object.assign(n,{spin:e.rotor_momentum,momentum:null}),n=fs(n,t,Ol(n)),![e.rotor_rate,e.rotor_moment,e.rotor_drive].some(o=>o!==void 0))return n;if(n.moment===null)throw new RangeError("system.rotor_rate needs system.rotor_moment, the rotor's own moment of inertia.");return s===null?n:zm(n,s)}function Nw(i,t){let{axis:e,moment:n,drive:s,velocity:r,attitude:o}=i,a=e.findIndex(l=>Math.abs(l)===1);if(n===null||s==="free"&&a<0)return null;let c=i.moments.map((l,h)=>s==="free"&&h===a?l+n:l);return`[body]
moments = ${Cn(c,"kg*m^2")}

[system]
kind = "gyrostat"
rotor_axis = [${e.map(Vt).join(", ")}]
rotor_moment = "${Vt(n)} kg*m^2"
rotor_rate = "${Vt(Fl(i))} rad/s"
rotor_drive = "${s}"

[spin]
angular_velocity = ${Cn(r,"rad/s")}
attitude = [${o.map(Vt).join(", ")}]

[time]
until = "${Vt(t)} s"
`}var Dw=(i,t)=>Bl(t);function Bl(i){let t=i.state(i.epoch),e=Math.hypot(...t.velocity)||1,n=i.state(i.epoch+40*Math.PI/e);return Object.entries(t.invariants).map(([s,r])=>{let[o,a]=[[r].flat(),[n.invariants[s]].flat()],c=Math.hypot(...o)||1;return[`${Tw[s]??s}, change in 20 turns`,$t(Math.hypot(...o.map((l,h)=>l-a[h]))/c,2)]})}var Qu={};qi(Qu,{asSpec:()=>Gw,changed:()=>zw,controls:()=>Bw,facts:()=>Ww,first:()=>Uw,from:()=>Fw,keys:()=>Ow,make:()=>kw,toml:()=>Hw,withSpec:()=>Vw});var km=9.80665,Uw=["spin.rate","spin.tilt","mgl"],Ow={system:{kind:0,moments:3,mgl:1,axis:3},spin:cs};function Fw({moments:i,mgl:t,axis:e,momentum:n,attitude:s=[1,0,0,0],epoch:r=0}){let o=n.map((c,l)=>c/i[l]),a=ls(o);return{moments:i,velocity:o,attitude:s,epoch:r,about:a,around:Ze(o,a).around,momentum:n,mgl:t,axis:e}}var Bw=i=>[{key:"mgl",label:"weight \xD7 distance to the centre of mass",unit:"N m",value:i.mgl,low:0,high:5*Math.abs(i.mgl)||1},...hs(i.moments),...us(i)],zw=(i,t,e)=>t==="mgl"?{...i,mgl:e}:ds(i,t,e),kw=i=>new Xo({...i,momentum:qn(i)}),Gw=({moments:i,mgl:t,axis:e,velocity:n,attitude:s})=>({system:{kind:"heavy-top",moments:i,mgl:t,axis:e},spin:{angular_velocity:n,attitude:s}});function Vw(i,t){let{system:e={}}=t,n={...i};return e.mgl!==void 0&&(n.mgl=Number(e.mgl)),e.axis&&(n.axis=e.axis.map(Number)),fs(n,e.moments?{...t,body:{moments:e.moments}}:t)}function Hw(i,t){let{moments:e,mgl:n,axis:s,velocity:r,attitude:o}=i,a=Math.hypot(...s),c=s.map(x=>x/a),l=[0,1,2].map(x=>.5*(e[0]+e[1]+e[2])-e[x]),h=c.reduce((x,m,g)=>x+(m?m*m/l[g]:0),0);if(n&&!(h>0&&Number.isFinite(h)))return null;let u=n?.5/h:0,d=n?u*km/n:0,f=n?n/(km*d):1,p=[0,1,2].map(x=>[0,1,2].map(m=>(x===m?e[x]-u:0)+u*c[x]*c[m]));return`# a body with the moments ${e.map(x=>$t(x)).join(", ")} kg m\xB2 about its point, and mgl = ${$t(n)} N m
[body]
mass = "${Vt(f)} kg"
inertia = [${p.map(x=>Cn(x,"kg*m^2")).join(", ")}]

[system]
kind = "heavy-top"
pivot = ${Cn(c.map(x=>-d*x),"m")}

[spin]
angular_velocity = ${Cn(r,"rad/s")}
attitude = [${o.map(Vt).join(", ")}]

[time]
until = "${Vt(t)} s"
`}var Ww=(i,t)=>Bl(t);var ed={};qi(ed,{asSpec:()=>t1,changed:()=>jw,controls:()=>Kw,facts:()=>s1,first:()=>Yw,from:()=>Jw,keys:()=>Zw,make:()=>Qw,toml:()=>n1,withSpec:()=>e1});var zl=Math.PI/30,qw=Math.PI/180,Gm=9.80665,Xw=1e-6,$w=1e-9,Yw=["lean","spin","precession"],Zw={system:{kind:0,moments:3,mgl:1,lean:1},spin:{spin:1,precession:1,nutation_rate:1,lean:1,momentum:3,attitude:4}};function Jw({moments:i,mgl:t,momentum:e,attitude:n=[1,0,0,0],epoch:s=0}){return{moments:i,mgl:t,...td(i,e,n),momentum:e,attitude:n,epoch:s}}function td(i,t,[e,n,s,r]){let o=t.map((p,x)=>p/i[x]),a=[2*(n*r-e*s),2*(s*r+e*n),e*e-n*n-s*s+r*r],c=Math.hypot(a[0],a[1]),l=2*Math.atan2(Math.hypot(n,s),Math.hypot(e,r));if(c<$w)return{lean:l<1?0:Math.PI,spin:o[2],precession:0,nutation:0,phi:2*Math.atan2(r,e),psi:0};let h=Math.atan2(r,e),u=Math.atan2(s,n),d=(o[0]*a[0]+o[1]*a[1])/c**2,f=(o[0]*a[1]-o[1]*a[0])/c;return{lean:l,precession:d,nutation:f,spin:o[2]-d*Math.cos(l),phi:h+u,psi:h-u}}function Vm({moments:i,lean:t,spin:e,precession:n,nutation:s,phi:r,psi:o}){let[a,c]=[Math.cos(.5*t),Math.sin(.5*t)],[l,h]=[.5*(r+o),.5*(r-o)],u=[a*Math.cos(l),c*Math.cos(h),c*Math.sin(h),a*Math.sin(l)],d=[n*Math.sin(t)*Math.sin(o)+s*Math.cos(o),n*Math.sin(t)*Math.cos(o)-s*Math.sin(o),n*Math.cos(t)+e];return{attitude:u,momentum:d.map((f,p)=>f*i[p])}}function Kw(i){let{moments:t,mgl:e,lean:n,spin:s,precession:r,nutation:o}=i,a=Math.max(Math.abs(s),Math.abs(r),Math.sqrt(Math.abs(e)/t[0]),1e-6),c={unit:"rpm",si:zl,low:-5*a,high:5*a};return[{key:"moments.0",label:"moment of inertia across, at the point",unit:"kg m\xB2",value:t[0],log:!0,low:Math.max(t[0]/10,.5*t[2]),high:10*t[0]},{key:"moments.2",label:"moment of inertia about the axis",unit:"kg m\xB2",value:t[2],log:!0,low:t[2]/10,high:Math.min(10*t[2],2*t[0])},{key:"mgl",label:"weight \xD7 distance to the centre of mass",unit:"N m",value:e,low:0,high:5*Math.abs(e)||1},{key:"lean",label:"lean",unit:"\xB0",si:qw,value:n,low:0,high:Math.PI},{key:"spin",label:"spin about its axis",value:s,...c},{key:"precession",label:"precession at the start",value:r,...c},{key:"nutation",label:"nutation at the start",value:o,...c}]}function jw(i,t,e){let n={...i};return t==="moments.0"?n.moments=[e,e,i.moments[2]]:t==="moments.2"?n.moments=[i.moments[0],i.moments[1],e]:n[t]=e,{...n,...Vm(n)}}function Qw({moments:i,mgl:t,momentum:e,attitude:n,epoch:s}){return new ta({moments:i,mgl:t,momentum:e,attitude:n,epoch:s})}function t1({moments:i,mgl:t,attitude:e,lean:n,spin:s,precession:r,nutation:o}){return{system:{kind:"lagrange-top",moments:i,mgl:t,lean:n},spin:{spin:s,precession:r,nutation_rate:o,attitude:e}}}function e1(i,{system:t={},spin:e={}}){let n={...i};if(t.moments&&(n.moments=t.moments.map(Number)),t.mgl!==void 0&&(n.mgl=Number(t.mgl)),e.attitude){let o=e.attitude.map(Number),a=(e.momentum??i.momentum).map(Number);n={...n,...td(n.moments,a,o),attitude:o,momentum:a}}else if(e.momentum){let o=e.momentum.map(Number);return{...n,...td(n.moments,o,n.attitude),momentum:o}}let s={lean:t.lean??e.lean,spin:e.spin,precession:e.precession,nutation:e.nutation_rate},r=Object.entries(s).filter(([,o])=>o!==void 0);if(!r.length&&!t.moments)return n;for(let[o,a]of r)n[o]=Number(a);return{...n,...Vm(n)}}function n1(i,t){let{moments:e,mgl:n,attitude:s,momentum:r}=i,o=.5*Math.min(.5*e[0],e[0]-.5*e[2]),a=o>0&&n?(n/Gm)**2/o:1,c=n/(a*Gm),l=e[0]-a*c*c,h=r.map((u,d)=>u/e[d]);return`# a body with these moments about its point, ${$t(e[0])} and ${$t(e[2])} kg m\xB2, and mgl = ${$t(n)} N m
[body]
mass = "${Vt(a)} kg"
moments = ["${Vt(l)} kg*m^2", "${Vt(l)} kg*m^2", "${Vt(e[2])} kg*m^2"]

[system]
kind = "lagrange-top"
pivot = ["0 m", "0 m", "${Vt(-c)} m"]

[spin]
angular_velocity = [${h.map(u=>`"${Vt(u)} rad/s"`).join(", ")}]
attitude = [${s.map(Vt).join(", ")}]

[time]
until = "${Vt(t)} s"
`}var i1={rest:"at rest",sleeping:"stands upright and spins",hanging:"hangs and spins",steady:"goes round at constant lean",free:"no weight: turns freely",planar:"swings like a pendulum",undulating:"nods while it goes round, always onward",cusp:"nods, halting at cusps",loop:"nods in loops",separatrix:"rises to the vertical and stays there"};function s1({moments:i,spin:t,mgl:e},n){let[s,r]=n.nutationLimits??[0,1],o=r-s<Xw&&n.regime==="undulating"?"steady":n.regime,a=[["what it does",i1[o]??o]],c=n.nutationPeriod,l=c!==null&&Number.isFinite(c);return l&&o!=="steady"&&a.push(["nods every",ii(c,c)]),l&&n.precessionPerPeriod!==null&&n.regime!=="planar"&&a.push(["mean precession",`${$t(n.precessionPerPeriod/c/zl,4)} rpm`]),t&&e&&a.push(["a gyroscope's, mgl/I\u2083\u03C9",`${$t(e/(i[2]*t)/zl,4)} rpm`]),e>0&&a.push(["sleeps upright from",`${$t(2*Math.sqrt(e*i[0])/i[2]/zl,4)} rpm`]),a}var sd={};qi(sd,{QuantumMotion:()=>Hl,asSpec:()=>L1,changed:()=>R1,controls:()=>T1,dragged:()=>b1,facts:()=>D1,first:()=>w1,from:()=>E1,keys:()=>A1,make:()=>I1,withDirection:()=>C1,withSpec:()=>N1});var Wm=2*Math.PI,r1=.5*(Math.sqrt(5)-1),o1=1-1e-15,qm=1e-12;function a1(i,t){let[e,n]=[1,Math.sqrt(1-t)],s=[];for(;e-n>qm*e;){let[a,c]=[.5*(e+n),.5*(e-n)];n=Math.sqrt(e*n),e=a,s.push(c/a)}let r=2**s.length*e*i;for(let a of s.reverse())r=.5*(r+Math.asin(a*Math.sin(r)));let o=Math.sin(r);return[o,Math.cos(r),Math.sqrt(1-t*o*o)]}function c1(i,t){let[e,n,s,r]=[1,Math.sqrt(1-t),i,1];for(;e-n>qm*e;){let o=Math.round(s/Math.PI)*Math.PI;s+=Math.atan(n/e*Math.tan(s-o))+o,[e,n,r]=[.5*(e+n),Math.sqrt(e*n),2*r]}return s/(r*e)}var nd=class{constructor([t,e,n],s,r){let[o,a,c]=r;this.unit=r,this.aboveSaddle=(t-e)*o*o>(e-n)*c*c;let l=(t-n)*o*o+(e-n)*a*a,h=(t-e)*a*a+(t-n)*c*c;if(!(h>0)||!(l>0)){this.rate=0;return}let[u,d]=this.aboveSaddle?[l,h]:[h,l],[f,p]=this.aboveSaddle?[t-e,e-n]:[e-n,t-e];this.m=Math.min(o1,p*d/(f*u)),this.rate=2*Wm*s*Math.sqrt(f*u);let x=this.aboveSaddle?o:c;this.sign=x<0?-1:1,this.long=this.sign*Math.sqrt(u/(t-n)),this.middle=this.sign*Math.sqrt(d/f),this.short=Math.sqrt(d/(t-n)),this.phase=c1(Math.atan2(a/this.middle,(this.aboveSaddle?c:o)/this.short),this.m)}at(t){if(!this.rate)return this.unit;let[e,n,s]=a1(this.rate*t+this.phase,this.m),[r,o,a]=[this.long*s,this.middle*e,this.short*n];return this.aboveSaddle?[r,o,a]:[a,o,r]}};function Xm(i,t,e,n){let s=Math.abs(e[0])<.6?[1,0,0]:[0,0,1],r=ea(Hm(e,s)),o=Hm(e,r);return Array.from({length:n},(a,c)=>{let l=((c+.5)/n)**(1/(4*t+1)),h=2*Math.asin(Math.sqrt(1-l)),u=Wm*(c*r1%1),[d,f,p]=[Math.sin(h)*Math.cos(u),Math.sin(h)*Math.sin(u),Math.cos(h)];return new nd(i,t+.5,ea(e.map((x,m)=>d*r[m]+f*o[m]+p*x)))})}var Hm=(i,t)=>[0,1,2].map(e=>i[(e+1)%3]*t[(e+2)%3]-i[(e+2)%3]*t[(e+1)%3]),ea=i=>i.map(t=>t/Math.hypot(...i));var l1=4,h1=1e-13,Ym=(i,t,e,n,s)=>{let r=1-s;return i.clone().multiplyScalar(r*r*(1+2*s)).addScaledVector(t,s*s*(3-2*s)).addScaledVector(e,s*r*r).addScaledVector(n,-s*s*r)},$m=(i,t,e)=>i+e*(t-i);function Zm(i,t,e,n,s){let r=p=>new I(...i.map((x,m)=>p.getComponent(m)/x)),[o,a]=[r(t.momentum),r(e.momentum)],c=(p,x)=>p.clone().cross(x).multiplyScalar(n),l=Ym(t.momentum,e.momentum,c(t.momentum,o),c(e.momentum,a),s),h=u1(i,t.momentum,e.momentum,l,s);if(!t.attitude)return{momentum:h,attitude:null};let u=d1(t.attitude,e.attitude,o.multiplyScalar(n),a.multiplyScalar(n),s),d=t.momentum.clone().applyQuaternion(t.attitude);d.lerp(e.momentum.clone().applyQuaternion(e.attitude),s).normalize();let f=h.clone().applyQuaternion(u).normalize();return{momentum:h,attitude:new ae().setFromUnitVectors(f,d).multiply(u)}}function u1(i,t,e,n,s){let r=$m(t.length(),e.length(),s);if(!(r>0))return n;let o=Math.min(...i),a=new I(...i.map(u=>o/u)),c=u=>u.clone().multiply(a).dot(u),l=$m(c(t.clone().divideScalar(r)),c(e.clone().divideScalar(r)),s),h=n.clone().divideScalar(r);for(let u=0;u<l1;u++){let d=h.clone().multiply(a),[f,p,x]=[h.dot(h),h.dot(d),d.dot(d)],m=f*x-p*p;if(m<h1)return h.normalize().multiplyScalar(r);let[g,y]=[.5*(1-f),.5*(l-p)];h.addScaledVector(h.clone(),(g*x-y*p)/m).addScaledVector(d,(y*f-g*p)/m)}return h.multiplyScalar(r)}function d1(i,t,e,n,s){let r=i.clone().invert().multiply(t);r.w<0&&r.set(-r.x,-r.y,-r.z,-r.w);let o=new I(r.x,r.y,r.z),a=o.length(),c=2*Math.atan2(a,r.w),l=o.multiplyScalar(a>0?c/a:2),h=c>.001?1/c**2-1/(2*c*Math.tan(c/2)):1/12,u=l.clone().cross(n),d=n.clone().addScaledVector(u,.5).addScaledVector(l.clone().cross(u),h),f=Ym(new I,l,e,d,s),p=f.length();return p>0?i.clone().multiply(new ae().setFromAxisAngle(f.divideScalar(p),p)):i.clone()}var f1=.08,p1=24e3,m1={f8:Float64Array,f4:Float32Array,u4:Uint32Array,u2:Uint16Array,u1:Uint8Array};function ue(i){if(!i)return null;let t=atob(i.data),e=new Uint8Array(t.length);for(let n=0;n<t.length;n++)e[n]=t.charCodeAt(n);return new m1[i.kind](e.buffer)}var kl=class{constructor(t){this.times=ue(t.times),this.attitudes=ue(t.attitude),this.momenta=ue(t.momentum),this.velocities=ue(t.velocity),this.energies=ue(t.energy),this.joined=t.joined,this.space=new ae(t.space[1],t.space[2],t.space[3],t.space[0]),this.count=this.times.length,this.fastest=g1(this.velocities),this.free=t.free,this.fine=this.finely()}finely(){if(!this.joined||!this.free||!this.momenta)return 1;let t=0;for(let n=1;n<this.count;n++)t=Math.max(t,this.times[n]-this.times[n-1]);let e=Math.ceil(this.fastest*t/f1);return Math.max(1,Math.min(e,Math.floor(p1/this.count)))}get states(){return this.dense??=Array.from({length:(this.count-1)*this.fine+1},(t,e)=>this.at(e/this.fine)),this.dense}get span(){return this.times[this.count-1]-this.times[0]}attitude(t){let[e,n,s,r]=this.attitudes.subarray(4*t,4*t+4);return new ae(n,s,r,e)}at(t){let e=Math.min(Math.floor(t),this.count-1),n=this.joined&&e+1<this.count?t-e:0,s=a=>n?a[e]+n*(a[e+1]-a[e]):a[e],r=a=>{if(!a)return null;let c=new I().fromArray(a,3*e);return n?c.lerp(new I().fromArray(a,3*e+3),n):c},o={position:e+n,time:s(this.times),attitude:this.attitudes?this.attitude(e):null,momentum:r(this.momenta),velocity:r(this.velocities),energy:this.energies?s(this.energies):null};return n&&this.free&&this.momenta?Object.assign(o,this.freely(e,n)):n&&this.attitudes&&o.attitude.slerp(this.attitude(e+1),n),o}freely(t,e){let[n,s]=[t,t+1].map(a=>({momentum:new I().fromArray(this.momenta,3*a),attitude:this.attitudes?this.attitude(a):null})),r=Zm(this.free,n,s,this.times[t+1]-this.times[t],e),o=new I(...this.free.map((a,c)=>r.momentum.getComponent(c)/a));return{...r,velocity:this.velocities?o:null}}positionOf(t){let e=0,n=this.count-1;for(;n-e>1;){let r=e+n>>1;this.times[r]<=t?e=r:n=r}if(t>=this.times[n])return n;let s=this.times[n]-this.times[e];return e+(s>0?Math.max(0,(t-this.times[e])/s):0)}};function g1(i){let t=0;for(let e=0;i&&e<i.length;e+=3)t=Math.max(t,Math.hypot(i[e],i[e+1],i[e+2]));return t}var x1=2*Math.PI,Gl=class{constructor({J:t,energies:e,vectors:n,kernel:s}){this.J=t,this.size=2*t+1,this.energies=e,this.middle=e.reduce((r,o)=>r+o,0)/this.size,this.vectors=ue(n),this.kernel=s}level(t){return{re:Float64Array.from({length:this.size},(e,n)=>this.vectors[n*this.size+t]),im:new Float64Array(this.size)}}coherent([t,e,n]){let{J:s,size:r}=this,[o,a]=[Math.atan2(Math.hypot(t,n),e),Math.atan2(t,n)],[c,l]=[Math.log(Math.cos(.5*o)),Math.log(Math.sin(.5*o))],[h,u]=[new Float64Array(r),new Float64Array(r)],d=0;for(let f=0;f<r;f++){let[p,x]=[2*s-f,s-f],m=.5*d+(p?p*c:0)+(f?f*l:0);h[f]=Math.exp(m)*Math.cos(x*a),u[f]=-Math.exp(m)*Math.sin(x*a),d+=Math.log((2*s-f)/(f+1))}return{re:h,im:u}}parts({re:t,im:e}){let{size:n,vectors:s}=this,[r,o]=[new Float64Array(n),new Float64Array(n)];for(let a=0;a<n;a++)for(let c=0;c<n;c++)r[c]+=s[a*n+c]*t[a],o[c]+=s[a*n+c]*e[a];return{x:r,y:o}}at({x:t,y:e},n){let{size:s,vectors:r}=this,[o,a]=[new Float64Array(s),new Float64Array(s)];for(let c=0;c<s;c++){if(t[c]===0&&e[c]===0)continue;let l=(this.energies[c]-this.middle)*n,h=x1*(l-Math.round(l)),[u,d]=[Math.cos(h),Math.sin(h)],[f,p]=[u*t[c]-d*e[c],d*t[c]+u*e[c]];for(let x=0;x<s;x++)o[x]+=r[x*s+c]*f,a[x]+=r[x*s+c]*p}return{re:o,im:a}}mean({re:t,im:e}){let{J:n,size:s}=this,[r,o,a]=[0,0,0];for(let c=0;c<s;c++){if(o+=(n-c)*(t[c]*t[c]+e[c]*e[c]),c+1===s)continue;let l=Math.sqrt((c+1)*(2*n-c));a+=l*(t[c]*t[c+1]+e[c]*e[c+1]),r+=l*(t[c]*e[c+1]-e[c]*t[c+1])}return[r/n,o/n,a/n]}};function _1(i,t){let[e,n]=[Math.cos(.5*t),Math.sin(.5*t)],s=Float64Array.of(1);for(let r=1;r<=2*i;r++){let o=new Float64Array((r+1)*(r+1));for(let a=0;a<=r;a++)for(let c=0;c<=r;c++){let l=0;a<r&&c<r&&(l+=e*Math.sqrt((r-a)*(r-c))*s[a*r+c]),a<r&&c>0&&(l-=n*Math.sqrt((r-a)*c)*s[a*r+c-1]),a>0&&c<r&&(l+=n*Math.sqrt(a*(r-c))*s[(a-1)*r+c]),a>0&&c>0&&(l+=e*Math.sqrt(a*c)*s[(a-1)*r+c-1]),o[a*(r+1)+c]=l/r}s=o}return s}function y1(i,t,e){let n=2*i+1,s=_1(i,t),r=s.map((c,l)=>c*e[l%n]),o=new Float64Array(n*(n+1)/2),a=0;for(let c=0;c<n;c++)for(let l=0;l+c<n;l++){let h=0;for(let u=0;u<n;u++)h+=r[l*n+u]*s[(l+c)*n+u];o[a++]=h}return o}var Vl=class{constructor(t,e,n){[this.J,this.rows,this.columns]=[t,n,2*n];let s=2*t+1;this.kernels=Array.from({length:n},(o,a)=>y1(t,(a+.5)*Math.PI/n,e));let r=o=>(o+.5)*2*Math.PI/this.columns;this.cosines=Array.from({length:s},(o,a)=>Float64Array.from({length:this.columns},(c,l)=>Math.cos(a*r(l)))),this.sines=Array.from({length:s},(o,a)=>Float64Array.from({length:this.columns},(c,l)=>Math.sin(a*r(l))))}of({re:t,im:e}){let{rows:n,columns:s}=this,r=2*this.J+1,[o,a]=[new Float64Array(r*(r+1)/2),new Float64Array(r*(r+1)/2)],c=0;for(let u=0;u<r;u++)for(let d=0;d+u<r;d++,c++){let f=u?2:1;o[c]=f*(t[d]*t[d+u]+e[d]*e[d+u]),a[c]=f*(t[d]*e[d+u]-e[d]*t[d+u])}let l=new Float32Array(n*s),h=new Float64Array(s);for(let u=0;u<n;u++){let d=this.kernels[u];h.fill(0);let f=0;for(let p=0;p<r;p++){let[x,m]=[0,0];for(let S=0;S+p<r;S++,f++)x+=d[f]*o[f],m+=d[f]*a[f];let[g,y]=[this.cosines[p],this.sines[p]];for(let S=0;S<s;S++)h[S]+=x*g[S]+m*y[S]}l.set(h,u*s)}return l}};var Jm=Math.PI/180,gi=-1,v1=400,M1=500,[Km,S1]=[[64,192],6],b1=!0,w1=["state.level","state.lean","state.towards"],A1={state:{level:1,direction:3}};function E1(i){let t=i.vectors?new Gl(i):null;return{...i,spin:t,rotor:{map:null},level:i.level??gi,first:i.direction}}function T1({spin:i,levels:t,level:e,direction:n}){let s=t.map(({name:c},l)=>[l,c]),r={key:"state.level",label:i?"state":"level",value:e,choices:i?[[gi,"L as sharp as it can be"],...s]:s};if(e!==gi)return[r];let{lean:o,towards:a}=id(n);return[r,{key:"state.lean",label:"L leans from the b axis by",unit:"\xB0",si:Jm,value:o,low:0,high:Math.PI},{key:"state.towards",label:"towards (0\xB0 is a, 90\xB0 is c)",unit:"\xB0",si:Jm,value:a,low:-Math.PI,high:Math.PI}]}var id=([i,t,e])=>({lean:Math.atan2(Math.hypot(i,e),t),towards:i||e?Math.atan2(e,i):0});function R1(i,t,e){if(t==="state.level")return jm(i,e);let{lean:n,towards:s}={...id(i.direction),towards:i.towards??id(i.direction).towards,[t.split(".")[1]]:e},r=[Math.sin(n)*Math.cos(s),Math.cos(n),Math.sin(n)*Math.sin(s)];return{...i,direction:r,towards:s,level:gi}}function jm(i,t){let e=Number(t);if(e===gi&&i.spin)return{...i,level:e};if(!Number.isInteger(e)||!i.levels[e])throw new RangeError(`state.level must be a whole number from 0 to ${i.levels.length-1}; got ${t}.`);return{...i,level:e,direction:i.levels[e].start}}function C1(i,t){if(i.level===gi)return{...i,direction:t,towards:null};let e=o=>o.reduce((a,c,l)=>a+i.constants[l]*c*c,0),n=e(t),s=i.levels.map(({start:o})=>Math.abs(e(o)-n)),r=s.indexOf(Math.min(...s));return{...i,level:r,direction:P1(i.constants,i.levels[r].start,t)}}function P1([i,t,e],n,s){let r=i*n[0]**2+e*n[2]**2,o=r>t,[a,c]=o?[0,2]:[2,0],l=Math.sqrt((o?i-r:r-e)/(o?i-t:t-e)),h=Math.abs(n[c]);if(!(h>0)||!Number.isFinite(l))return n;let u=Math.atan2(s[1]/l,s[c]/h),d=[0,0,0];return[d[c],d[1]]=[h*Math.cos(u),Math.min(1,l)*Math.sin(u)],d[a]=(s[a]<0?-1:1)*Math.sqrt(Math.max(0,1-d[c]**2-d[1]**2)),ea(d)}var Hl=class extends ki{constructor({moments:t,constants:e,momentumSize:n,attitude:s,direction:r,level:o,levels:a,spin:c,rotor:l,J:h}){super({moments:t,momentum:r.map(u=>u*n),attitude:s,epoch:0}),[this.constants,this.spin,this.J,this.rotor]=[e,c,h,l],this.level=o===gi?null:o,this.ladder=a,this.direction=r,this.parts=this.level===null?c.parts(c.coherent(r)):null,this.wanted=this.level===null?this.flipping():null}flipping(){let[t,e,n]=this.constants,s=4*Math.PI*(this.J+.5)*Math.sqrt((t-e)*(e-n)),r=Number.isFinite(this.period??NaN)?this.period:1/0,o=Math.min(3*r,2*(2*Math.log(this.J)+8)/s);return Number.isFinite(o)?o:null}spinAt(t){return this.parts?this.spin.at(this.parts,t):this.spin.level(this.level)}get map(){let t=Math.min(Km[1],Math.max(Km[0],S1*this.J));return this.rotor.map??=new Vl(this.J,this.spin.kernel,t),this.rotor.map}get cloud(){return this.members??=this.parts?Xm(this.constants,this.J,this.direction,v1):[],this.members}plots(t){if(!this.parts)return null;let e=Math.max(1,Math.ceil(t.length/M1)),n=t.filter((l,h)=>h%e===0||h===t.length-1),s=Math.hypot(...this.state(0).momentum),r=n.map(l=>this.spin.mean(this.spinAt(l))),o=n.map(l=>this.state(l).momentum[1]/s),a=n.map(l=>this.meanOfCloud(l)[1]),c=(l,h)=>({name:l,times:n,values:h});return[{title:"L along the b axis, in |L|",unit:"",series:[c("quantum \u27E8L\u27E9",r.map(l=>l[1])),c("one classical body",o),c("mean of classical bodies",a)]},{title:"quantum \u27E8L\u27E9 along the axes, in J",unit:"",along:!0,series:["a","b","c"].map((l,h)=>c(l,r.map(u=>u[h])))}]}meanOfCloud(t){let e=[0,0,0];for(let n of this.cloud)n.at(t).forEach((s,r)=>e[r]+=s);return e.map(n=>n/this.cloud.length*((this.J+.5)/this.J))}},I1=i=>new Hl(i),L1=({level:i,direction:t})=>({state:i===gi?{direction:t}:{level:i}});function N1(i,{state:t={}}){if(t.direction){if(!i.spin)throw new RangeError(`state.direction asks for a state of a spin, which the page has up to J = ${i.largestJ}. Set state.level.`);if(!(Math.hypot(...t.direction)>0))throw new RangeError("state.direction must not be zero.");return{...i,level:gi,direction:ea(t.direction),towards:null}}return t.level===void 0?i:jm(i,t.level)}function D1({level:i,levels:t,constants:e,J:n,said:s,direction:r,first:o},a){if(i!==gi)return t[i].said;let c=(n+.5)**2*r.reduce((u,d,f)=>u+e[f]*d*d,0),l=[["classical energy E/hc",`${$t(c/29979245800,7)} cm\u207B\xB9`]],{period:h}=a;return h!==null&&Number.isFinite(h)&&l.push(["classical L goes round its polhode in",ii(h,h)]),r===o?[...l,...s]:l}var Qm={DampedBody:Wu,EulerDisk:Xu,FreeMotion:Ku,Gyrostat:ju,HeavyTop:Qu,LagrangeMotion:ed,QuantumRotor:sd};var tg=.08,U1=8,[O1,F1]=[400,3e3],B1=24e3,rd=.5,Wl=([i,t,e,n])=>new ae(t,e,n,i),ql=class i{constructor(t,e=null,n=null){this.solver=t,this.moments=t.moments,this.free=t instanceof ki?t.moments:null,this.hasUp=t.mgl!==void 0||!!t.onPlane,this.endless=!0,this.joined=!0,this.times=e?.length?e:this.window(t.epoch),this.count=this.times.length,this.space=n?Wl(n):this.upright(),this.fill(),this.fine=Math.max(1,Math.min(Math.ceil(this.fastest*this.span/(tg*(this.count-1||1))),Math.floor(B1/this.count)))}window(t){let e=this.solver.mgl?.1*Math.sqrt(Math.abs(this.solver.mgl)/Math.max(...this.moments)):0,n=Math.max(this.speedAt(t),e)||1,s=this.solver.wanted??z1(this.solver,n),r=Math.max(O1,Math.min(F1,Math.ceil(s*n/tg)+1));return Float64Array.from({length:r},(o,a)=>t+s*a/(r-1))}speedAt(t){return Math.hypot(...this.solved(t).velocity)}upright(){if(this.hasUp)return new ae;let{attitude:t,momentum:e}=this.solver.state(this.solver.epoch),n=new I(...e).applyQuaternion(Wl(t));return n.length()>0?new ae().setFromUnitVectors(n.normalize(),new I(0,0,1)):new ae}fill(){this.attitudes=new Float64Array(4*this.count),this.momenta=new Float64Array(3*this.count),this.velocities=new Float64Array(3*this.count),this.energies=new Float64Array(this.count),this.fastest=0,this.dense=null;for(let t=0;t<this.count;t++){let{attitude:e,momentum:n,velocity:s,energy:r}=this.solved(this.times[t]);this.attitudes.set(e,4*t),this.momenta.set(n,3*t),this.velocities.set(s,3*t),this.fastest=Math.max(this.fastest,Math.hypot(...s)),this.energies[t]=r}}solved(t){let e=this.solver.state(t);if(e.velocity)return e;let n=e.momentum.map((l,h)=>l/this.moments[h]),s=.5*e.momentum.reduce((l,h,u)=>l+h*n[u],0),[r,o,a,c]=e.attitude;return{...e,velocity:n,energy:this.hasUp?s+this.solver.mgl*(r*r-o*o-a*a+c*c):s}}get states(){return this.dense??=Array.from({length:(this.count-1)*this.fine+1},(t,e)=>this.at(e/this.fine)),this.dense}get span(){return this.times[this.count-1]-this.times[0]}attitude(t){return Wl(this.attitudes.subarray(4*t,4*t+4))}at(t){let e=Math.min(Math.floor(t),this.count-1),n=e+1<this.count?t-e:0,s=n?this.times[e]+n*(this.times[e+1]-this.times[e]):this.times[e];return{position:e+n,...this.solvedAt(s)}}solvedAt(t){let{attitude:e,momentum:n,velocity:s,energy:r}=this.solved(t);return{time:t,attitude:Wl(e),momentum:new I(...n),velocity:new I(...s),energy:r}}positionOf(t){let e=this.span>0?(t-this.times[0])/this.span:0;return Math.min(this.count-1,Math.max(0,e*(this.count-1)))}around(t){let[e,n]=[this.times[0],this.times[this.count-1]];if(t>=e&&t<=n)return this;let s=t>n&&t<n+(1-rd)*this.span?n-rd*this.span:t-rd*this.span,r=this.span/(this.count-1),o=this.times.map((u,d)=>s+d*r),{w:a,x:c,y:l,z:h}=this.space;return new i(this.solver,o,[a,c,l,h])}};function z1(i,t){let e=U1*2*Math.PI/t,n=i.period??i.nutationPeriod??null;return n!==null&&Number.isFinite(n)?Math.max(e,Math.min(2.2*n,12*e)):e}var k1=3,na=i=>document.getElementById(i),Xl=class{constructor(t,e){this.kind=Qm[t.solver],this.given=t,this.changed=e,this.setting=this.first=this.kind.from(t),this.solver=this.kind.make(this.setting);let n={first:na("controls"),more:na("more"),fold:na("folded")};this.controls=new vl(n,(s,r)=>this.move(s,r),s=>this.say(s)),this.show()}motion(t=null,e=null){return new ql(this.solver,t,e)}get event(){return this.kind.event?.(this.setting,this.solver)??null}show(){let t=this.kind.controls(this.setting);this.controls.show(t,this.kind.first??t.slice(0,k1).map(({key:e})=>e)),Dp(na("facts"),this.kind.facts(this.setting,this.solver))}take(t){let e=[this.solver,this.setting];try{this.solver=this.kind.make(t)}catch(s){return this.say(s.message),!1}this.say("");let n=String(t.moments)!==String(this.first.moments);this.setting=t;try{this.show(),this.changed(n)}catch(s){return[this.solver,this.setting]=e,this.show(),this.changed(String(this.setting.moments)!==String(this.first.moments)),this.say(s.message),!1}return!0}move(t,e){t===null?this.show():this.take(this.kind.changed(this.setting,t,e))}set(t){try{return G1(t,this.kind.keys),this.take(this.kind.withSpec(this.setting,t))}catch(e){return this.say(e.message),!1}}point(t){this.take(this.kind.withDirection(this.setting,t))}get isAsGiven(){return this.setting===this.first}reset(){this.take(this.first)}say(t){na("refused").textContent=t}get tables(){return this.isAsGiven?{}:this.kind.asSpec(this.setting)}toml(t){return this.kind.toml?.(this.setting,t)??null}};function G1(i,t){if(typeof i!="object"||i===null||Array.isArray(i))throw new RangeError("set takes tables like {spin: {rate: 12}}.");for(let[e,n]of Object.entries(i)){if(!t[e])throw new RangeError(`There is no table ${e} here; there are ${Object.keys(t).join(", ")}.`);if(typeof n!="object"||n===null)throw new RangeError(`${e} must be a table of keys and values.`);for(let[s,r]of Object.entries(n)){if(!(s in t[e]))throw new RangeError(`There is no key ${e}.${s} here; there are ${Object.keys(t[e]).join(", ")}.`);let o=t[e][s],a=[r].flat();if(!(o===0?typeof r=="string":a.length===o&&Array.isArray(r)===o>1)||o&&!a.every(l=>typeof l=="number"&&Number.isFinite(l))){let l=o===0?"a word":o===1?"a finite number":`${o} finite numbers in brackets`;throw new RangeError(`${e}.${s} must be ${l}; got ${JSON.stringify(r)}.`)}}}}var $l=class{constructor(t,e){this.root=t,this.changed=e,this.large=0}take(t){this.types=t,this.root.dataset.count=String(t.length),[...this.root.children].forEach((e,n)=>e.querySelector(".enlarge").addEventListener("click",()=>this.enlarge(n,!0))),this.large=0,this.mark()}get named(){return this.large?this.types[this.large]:null}enlarge(t,e=!1){let n=typeof t=="number"?t:this.types.indexOf(t);return n<0?!1:(this.large=n,this.mark(),e&&this.root.children[n].querySelector("canvas").focus({preventScroll:!0}),this.changed(),!0)}mark(){[...this.root.children].forEach((t,e)=>t.classList.toggle("large",e===this.large))}},Yl=class{constructor(t){this.elements=t,window.addEventListener("resize",()=>this.release())}keep(){for(let t of this.elements){let{height:e}=t.getBoundingClientRect();e>parseFloat(t.style.minHeight||0)&&(t.style.minHeight=`${e}px`)}}release(){for(let t of this.elements)t.style.minHeight=""}};var eg=new ln,Zl=new I,_s=class extends Eo{constructor(){super(),this.isLineSegmentsGeometry=!0,this.type="LineSegmentsGeometry";let t=[-1,2,0,1,2,0,-1,1,0,1,1,0,-1,0,0,1,0,0,-1,-1,0,1,-1,0],e=[-1,2,1,2,-1,1,1,1,-1,-1,1,-1,-1,-2,1,-2],n=[0,2,1,2,3,1,2,4,3,4,5,3,4,6,5,6,7,5];this.setIndex(n),this.setAttribute("position",new re(t,3)),this.setAttribute("uv",new re(e,2))}applyMatrix4(t){let e=this.attributes.instanceStart,n=this.attributes.instanceEnd;return e!==void 0&&(e.applyMatrix4(t),n.applyMatrix4(t),e.needsUpdate=!0),this.boundingBox!==null&&this.computeBoundingBox(),this.boundingSphere!==null&&this.computeBoundingSphere(),this}setPositions(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new is(e,6,1);return this.setAttribute("instanceStart",new zn(n,3,0)),this.setAttribute("instanceEnd",new zn(n,3,3)),this.instanceCount=this.attributes.instanceStart.count,this.computeBoundingBox(),this.computeBoundingSphere(),this}setColors(t){let e;t instanceof Float32Array?e=t:Array.isArray(t)&&(e=new Float32Array(t));let n=new is(e,6,1);return this.setAttribute("instanceColorStart",new zn(n,3,0)),this.setAttribute("instanceColorEnd",new zn(n,3,3)),this}fromWireframeGeometry(t){return this.setPositions(t.attributes.position.array),this}fromEdgesGeometry(t){return this.setPositions(t.attributes.position.array),this}fromMesh(t){return this.fromWireframeGeometry(new yo(t.geometry)),this}fromLineSegments(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}computeBoundingBox(){this.boundingBox===null&&(this.boundingBox=new ln);let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;t!==void 0&&e!==void 0&&(this.boundingBox.setFromBufferAttribute(t),eg.setFromBufferAttribute(e),this.boundingBox.union(eg))}computeBoundingSphere(){this.boundingSphere===null&&(this.boundingSphere=new xn),this.boundingBox===null&&this.computeBoundingBox();let t=this.attributes.instanceStart,e=this.attributes.instanceEnd;if(t!==void 0&&e!==void 0){let n=this.boundingSphere.center;this.boundingBox.getCenter(n);let s=0;for(let r=0,o=t.count;r<o;r++)Zl.fromBufferAttribute(t,r),s=Math.max(s,n.distanceToSquared(Zl)),Zl.fromBufferAttribute(e,r),s=Math.max(s,n.distanceToSquared(Zl));this.boundingSphere.radius=Math.sqrt(s),isNaN(this.boundingSphere.radius)&&console.error("THREE.LineSegmentsGeometry.computeBoundingSphere(): Computed radius is NaN. The instanced position data is likely to have NaN values.",this)}}toJSON(){}};ft.line={worldUnits:{value:1},linewidth:{value:1},resolution:{value:new Wt},dashOffset:{value:0},dashScale:{value:1},dashSize:{value:1},gapSize:{value:1}};dn.line={uniforms:Oo.merge([ft.common,ft.fog,ft.line]),vertexShader:`
		#include <common>
		#include <color_pars_vertex>
		#include <fog_pars_vertex>
		#include <logdepthbuf_pars_vertex>
		#include <clipping_planes_pars_vertex>

		uniform float linewidth;
		uniform vec2 resolution;

		attribute vec3 instanceStart;
		attribute vec3 instanceEnd;

		attribute vec3 instanceColorStart;
		attribute vec3 instanceColorEnd;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#ifdef USE_DASH

			uniform float dashScale;
			attribute float instanceDistanceStart;
			attribute float instanceDistanceEnd;
			varying float vLineDistance;

		#endif

		float trimSegmentAlpha( const in vec4 start, const in vec4 end ) {

			// compute the interpolation factor needed to trim the segment so it terminates
			// between the camera plane and the near plane

			// conservative estimate of the near plane
			float a = projectionMatrix[ 2 ][ 2 ]; // 3nd entry in 3th column
			float b = projectionMatrix[ 3 ][ 2 ]; // 3nd entry in 4th column

			// we need different nearEstimate formula for reversed and default depth buffer
			// a is positive with a reversed depth buffer so it can be used for controlling the code flow
			float nearEstimate = ( a > 0.0 ) ? ( - b / ( a + 1.0 ) ) : ( - 0.5 * b / a );

			return ( nearEstimate - start.z ) / ( end.z - start.z );

		}

		void main() {

			#ifdef USE_COLOR

				vColor.xyz = ( position.y < 0.5 ) ? instanceColorStart : instanceColorEnd;

			#endif

			float aspect = resolution.x / resolution.y;

			// camera space
			vec4 start = modelViewMatrix * vec4( instanceStart, 1.0 );
			vec4 end = modelViewMatrix * vec4( instanceEnd, 1.0 );

			#ifdef USE_DASH

				float lineDistanceStart = dashScale * instanceDistanceStart;
				float lineDistanceEnd = dashScale * instanceDistanceEnd;

			#endif

			#ifdef WORLD_UNITS

				worldStart = start.xyz;
				worldEnd = end.xyz;

			#else

				vUv = uv;

			#endif

			// special case for perspective projection, and segments that terminate either in, or behind, the camera plane
			// clearly the gpu firmware has a way of addressing this issue when projecting into ndc space
			// but we need to perform ndc-space calculations in the shader, so we must address this issue directly
			// perhaps there is a more elegant solution -- WestLangley

			bool perspective = ( projectionMatrix[ 2 ][ 3 ] == - 1.0 ); // 4th entry in the 3rd column

			if ( perspective ) {

				if ( start.z < 0.0 && end.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( start, end );
					end.xyz = mix( start.xyz, end.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceEnd = mix( lineDistanceStart, lineDistanceEnd, alpha );

					#endif

				} else if ( end.z < 0.0 && start.z >= 0.0 ) {

					float alpha = trimSegmentAlpha( end, start );
					start.xyz = mix( end.xyz, start.xyz, alpha );

					#ifdef USE_DASH

						lineDistanceStart = mix( lineDistanceEnd, lineDistanceStart, alpha );

					#endif

				}

			}

			#ifdef USE_DASH

				vLineDistance = ( position.y < 0.5 ) ? lineDistanceStart : lineDistanceEnd;
				vUv = uv;

			#endif

			// clip space
			vec4 clipStart = projectionMatrix * start;
			vec4 clipEnd = projectionMatrix * end;

			// ndc space
			vec3 ndcStart = clipStart.xyz / clipStart.w;
			vec3 ndcEnd = clipEnd.xyz / clipEnd.w;

			// direction
			vec2 dir = ndcEnd.xy - ndcStart.xy;

			// account for clip-space aspect ratio
			dir.x *= aspect;
			dir = normalize( dir );

			#ifdef WORLD_UNITS

				vec3 worldDir = normalize( end.xyz - start.xyz );
				vec3 tmpFwd = perspective ? normalize( mix( start.xyz, end.xyz, 0.5 ) ) : vec3( 0.0, 0.0, - 1.0 );
				vec3 worldUp = normalize( cross( worldDir, tmpFwd ) );
				vec3 worldFwd = cross( worldDir, worldUp );
				worldPos = position.y < 0.5 ? start: end;

				// height offset
				float hw = linewidth * 0.5;
				worldPos.xyz += position.x < 0.0 ? hw * worldUp : - hw * worldUp;

				// don't extend the line if we're rendering dashes because we
				// won't be rendering the endcaps
				#ifndef USE_DASH

					// cap extension
					worldPos.xyz += position.y < 0.5 ? - hw * worldDir : hw * worldDir;

					// add width to the box
					worldPos.xyz += worldFwd * hw;

					// endcaps
					if ( position.y > 1.0 || position.y < 0.0 ) {

						worldPos.xyz -= worldFwd * 2.0 * hw;

					}

				#endif

				// project the worldpos
				vec4 clip = projectionMatrix * worldPos;

				// shift the depth of the projected points so the line
				// segments overlap neatly
				vec3 clipPose = ( position.y < 0.5 ) ? ndcStart : ndcEnd;

				// only shift the depth of vertices in front of the camera (#35137)
				if ( clip.w > 0.0 ) clip.z = clipPose.z * clip.w;

			#else

				vec2 offset = vec2( dir.y, - dir.x );
				// undo aspect ratio adjustment
				dir.x /= aspect;
				offset.x /= aspect;

				// sign flip
				if ( position.x < 0.0 ) offset *= - 1.0;

				// endcaps
				if ( position.y < 0.0 ) {

					offset += - dir;

				} else if ( position.y > 1.0 ) {

					offset += dir;

				}

				// adjust for linewidth
				offset *= linewidth;

				// adjust for clip-space to screen-space conversion // maybe resolution should be based on viewport ...
				offset /= resolution.y;

				// select end
				vec4 clip = ( position.y < 0.5 ) ? clipStart : clipEnd;

				// back to clip space
				offset *= clip.w;

				clip.xy += offset;

			#endif

			gl_Position = clip;

			vec4 mvPosition = ( position.y < 0.5 ) ? start : end; // this is an approximation

			#include <logdepthbuf_vertex>
			#include <clipping_planes_vertex>
			#include <fog_vertex>

		}
		`,fragmentShader:`
		uniform vec3 diffuse;
		uniform float opacity;
		uniform float linewidth;

		#ifdef USE_DASH

			uniform float dashOffset;
			uniform float dashSize;
			uniform float gapSize;

		#endif

		varying float vLineDistance;

		#ifdef WORLD_UNITS

			varying vec4 worldPos;
			varying vec3 worldStart;
			varying vec3 worldEnd;

			#ifdef USE_DASH

				varying vec2 vUv;

			#endif

		#else

			varying vec2 vUv;

		#endif

		#include <common>
		#include <color_pars_fragment>
		#include <fog_pars_fragment>
		#include <logdepthbuf_pars_fragment>
		#include <clipping_planes_pars_fragment>

		vec2 closestLineToLine(vec3 p1, vec3 p2, vec3 p3, vec3 p4) {

			float mua;
			float mub;

			vec3 p13 = p1 - p3;
			vec3 p43 = p4 - p3;

			vec3 p21 = p2 - p1;

			float d1343 = dot( p13, p43 );
			float d4321 = dot( p43, p21 );
			float d1321 = dot( p13, p21 );
			float d4343 = dot( p43, p43 );
			float d2121 = dot( p21, p21 );

			float denom = d2121 * d4343 - d4321 * d4321;

			float numer = d1343 * d4321 - d1321 * d4343;

			mua = numer / denom;
			mua = clamp( mua, 0.0, 1.0 );
			mub = ( d1343 + d4321 * ( mua ) ) / d4343;
			mub = clamp( mub, 0.0, 1.0 );

			return vec2( mua, mub );

		}

		void main() {

			float alpha = opacity;
			vec4 diffuseColor = vec4( diffuse, alpha );

			#include <clipping_planes_fragment>

			#ifdef USE_DASH

				if ( vUv.y < - 1.0 || vUv.y > 1.0 ) discard; // discard endcaps

				if ( mod( vLineDistance + dashOffset, dashSize + gapSize ) > dashSize ) discard; // todo - FIX

			#endif

			#ifdef WORLD_UNITS

				float len;

				if ( isOrthographic ) {

					// View rays are parallel to the z axis so the distance reduces to camera-space XY
					vec2 lineDir = worldEnd.xy - worldStart.xy;
					float t = clamp( dot( worldPos.xy - worldStart.xy, lineDir ) / dot( lineDir, lineDir ), 0.0, 1.0 );
					len = length( worldStart.xy + lineDir * t - worldPos.xy );

				} else {

					// Find the closest points on the view ray and the line segment
					vec3 rayEnd = normalize( worldPos.xyz ) * 1e5;
					vec3 lineDir = worldEnd - worldStart;
					vec2 params = closestLineToLine( worldStart, worldEnd, vec3( 0.0, 0.0, 0.0 ), rayEnd );

					vec3 p1 = worldStart + lineDir * params.x;
					vec3 p2 = rayEnd * params.y;
					vec3 delta = p1 - p2;
					len = length( delta );

				}

				float norm = len / linewidth;

				#ifndef USE_DASH

					#ifdef USE_ALPHA_TO_COVERAGE

						float dnorm = fwidth( norm );
						alpha = 1.0 - smoothstep( 0.5 - dnorm, 0.5 + dnorm, norm );

					#else

						if ( norm > 0.5 ) {

							discard;

						}

					#endif

				#endif

			#else

				#ifdef USE_ALPHA_TO_COVERAGE

					// artifacts appear on some hardware if a derivative is taken within a conditional
					float a = vUv.x;
					float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
					float len2 = a * a + b * b;
					float dlen = fwidth( len2 );

					if ( abs( vUv.y ) > 1.0 ) {

						alpha = 1.0 - smoothstep( 1.0 - dlen, 1.0 + dlen, len2 );

					}

				#else

					if ( abs( vUv.y ) > 1.0 ) {

						float a = vUv.x;
						float b = ( vUv.y > 0.0 ) ? vUv.y - 1.0 : vUv.y + 1.0;
						float len2 = a * a + b * b;

						if ( len2 > 1.0 ) discard;

					}

				#endif

			#endif

			#include <logdepthbuf_fragment>
			#include <color_fragment>

			gl_FragColor = vec4( diffuseColor.rgb, alpha );

			#include <tonemapping_fragment>
			#include <colorspace_fragment>
			#include <fog_fragment>
			#include <premultiplied_alpha_fragment>

		}
		`};var ys=class extends kn{constructor(t){super({type:"LineMaterial",uniforms:Oo.clone(dn.line.uniforms),vertexShader:dn.line.vertexShader,fragmentShader:dn.line.fragmentShader,clipping:!0}),this.isLineMaterial=!0,this.setValues(t)}get color(){return this.uniforms.diffuse.value}set color(t){this.uniforms.diffuse.value=t}get worldUnits(){return"WORLD_UNITS"in this.defines}set worldUnits(t){t===!0!==this.worldUnits&&(this.needsUpdate=!0),t===!0?this.defines.WORLD_UNITS="":delete this.defines.WORLD_UNITS}get linewidth(){return this.uniforms.linewidth.value}set linewidth(t){this.uniforms.linewidth&&(this.uniforms.linewidth.value=t)}get dashed(){return"USE_DASH"in this.defines}set dashed(t){t===!0!==this.dashed&&(this.needsUpdate=!0),t===!0?this.defines.USE_DASH="":delete this.defines.USE_DASH}get dashScale(){return this.uniforms.dashScale.value}set dashScale(t){this.uniforms.dashScale.value=t}get dashSize(){return this.uniforms.dashSize.value}set dashSize(t){this.uniforms.dashSize.value=t}get dashOffset(){return this.uniforms.dashOffset.value}set dashOffset(t){this.uniforms.dashOffset.value=t}get gapSize(){return this.uniforms.gapSize.value}set gapSize(t){this.uniforms.gapSize.value=t}get opacity(){return this.uniforms.opacity.value}set opacity(t){this.uniforms&&(this.uniforms.opacity.value=t)}get resolution(){return this.uniforms.resolution.value}set resolution(t){this.uniforms.resolution.value.copy(t)}get alphaToCoverage(){return"USE_ALPHA_TO_COVERAGE"in this.defines}set alphaToCoverage(t){this.defines&&(t===!0!==this.alphaToCoverage&&(this.needsUpdate=!0),t===!0?this.defines.USE_ALPHA_TO_COVERAGE="":delete this.defines.USE_ALPHA_TO_COVERAGE)}};var od=new ce,ng=new I,ig=new I,Je=new ce,Ke=new ce,xi=new ce,ad=new I,cd=new te,je=new To,sg=new I,Jl=new ln,Kl=new xn,_i=new ce,yi,ks;function rg(i,t,e){return _i.set(0,0,-t,1).applyMatrix4(i.projectionMatrix),_i.multiplyScalar(1/_i.w),_i.x=ks/e.width,_i.y=ks/e.height,_i.applyMatrix4(i.projectionMatrixInverse),_i.multiplyScalar(1/_i.w),Math.abs(Math.max(_i.x,_i.y))}function V1(i,t){let e=i.matrixWorld,n=i.geometry,s=n.attributes.instanceStart,r=n.attributes.instanceEnd,o=Math.min(n.instanceCount,s.count);for(let a=0,c=o;a<c;a++){je.start.fromBufferAttribute(s,a),je.end.fromBufferAttribute(r,a),je.applyMatrix4(e);let l=new I,h=new I;yi.distanceSqToSegment(je.start,je.end,h,l),h.distanceTo(l)<ks*.5&&t.push({point:h,pointOnLine:l,distance:yi.origin.distanceTo(h),object:i,face:null,faceIndex:a,uv:null,uv1:null})}}function H1(i,t,e){let n=t.projectionMatrix,r=i.material.resolution,o=i.matrixWorld,a=i.geometry,c=a.attributes.instanceStart,l=a.attributes.instanceEnd,h=Math.min(a.instanceCount,c.count),u=-t.near;yi.at(1,xi),xi.w=1,xi.applyMatrix4(t.matrixWorldInverse),xi.applyMatrix4(n),xi.multiplyScalar(1/xi.w),xi.x*=r.x/2,xi.y*=r.y/2,xi.z=0,ad.copy(xi),cd.multiplyMatrices(t.matrixWorldInverse,o);for(let d=0,f=h;d<f;d++){if(Je.fromBufferAttribute(c,d),Ke.fromBufferAttribute(l,d),Je.w=1,Ke.w=1,Je.applyMatrix4(cd),Ke.applyMatrix4(cd),Je.z>u&&Ke.z>u)continue;if(Je.z>u){let S=Je.z-Ke.z,v=(Je.z-u)/S;Je.lerp(Ke,v)}else if(Ke.z>u){let S=Ke.z-Je.z,v=(Ke.z-u)/S;Ke.lerp(Je,v)}Je.applyMatrix4(n),Ke.applyMatrix4(n),Je.multiplyScalar(1/Je.w),Ke.multiplyScalar(1/Ke.w),Je.x*=r.x/2,Je.y*=r.y/2,Ke.x*=r.x/2,Ke.y*=r.y/2,je.start.copy(Je),je.start.z=0,je.end.copy(Ke),je.end.z=0;let x=je.closestPointToPointParameter(ad,!0);je.at(x,sg);let m=ll.lerp(Je.z,Ke.z,x),g=m>=-1&&m<=1,y=ad.distanceTo(sg)<ks*.5;if(g&&y){je.start.fromBufferAttribute(c,d),je.end.fromBufferAttribute(l,d),je.start.applyMatrix4(o),je.end.applyMatrix4(o);let S=new I,v=new I;yi.distanceSqToSegment(je.start,je.end,v,S),e.push({point:v,pointOnLine:S,distance:yi.origin.distanceTo(v),object:i,face:null,faceIndex:d,uv:null,uv1:null})}}}var Br=class extends ee{constructor(t=new _s,e=new ys({color:Math.random()*16777215})){super(t,e),this.isLineSegments2=!0,this.type="LineSegments2"}computeLineDistances(){let t=this.geometry,e=t.attributes.instanceStart,n=t.attributes.instanceEnd,s=new Float32Array(2*e.count);for(let o=0,a=0,c=e.count;o<c;o++,a+=2)ng.fromBufferAttribute(e,o),ig.fromBufferAttribute(n,o),s[a]=a===0?0:s[a-1],s[a+1]=s[a]+ng.distanceTo(ig);let r=new is(s,2,1);return t.setAttribute("instanceDistanceStart",new zn(r,1,0)),t.setAttribute("instanceDistanceEnd",new zn(r,1,1)),this}raycast(t,e){let n=this.material.worldUnits,s=t.camera;if(s===null&&!n&&console.error('LineSegments2: "Raycaster.camera" needs to be set in order to raycast against LineSegments2 while worldUnits is set to false.'),n===!1&&(this.material.resolution.x===0||this.material.resolution.y===0))return;let r=t.params.Line2!==void 0&&t.params.Line2.threshold||0;yi=t.ray;let o=this.matrixWorld,a=this.geometry,c=this.material;ks=c.linewidth+r,a.boundingSphere===null&&a.computeBoundingSphere(),Kl.copy(a.boundingSphere).applyMatrix4(o);let l;if(n)l=ks*.5;else{let u=Math.max(s.near,Kl.distanceToPoint(yi.origin));l=rg(s,u,c.resolution)}if(Kl.radius+=l,yi.intersectsSphere(Kl)===!1)return;a.boundingBox===null&&a.computeBoundingBox(),Jl.copy(a.boundingBox).applyMatrix4(o);let h;if(n)h=ks*.5;else{let u=Math.max(s.near,Jl.distanceToPoint(yi.origin));h=rg(s,u,c.resolution)}Jl.expandByScalar(h),yi.intersectsBox(Jl)!==!1&&(n?V1(this,e):H1(this,s,e))}onBeforeRender(t){let e=this.material.uniforms;e&&e.resolution&&(t.getViewport(od),this.material.uniforms.resolution.value.set(od.z,od.w))}};var zr=class extends _s{constructor(){super(),this.isLineGeometry=!0,this.type="LineGeometry"}setPositions(t){let e=t.length-3,n=new Float32Array(2*e);for(let s=0;s<e;s+=3)n[2*s]=t[s],n[2*s+1]=t[s+1],n[2*s+2]=t[s+2],n[2*s+3]=t[s+3],n[2*s+4]=t[s+4],n[2*s+5]=t[s+5];return super.setPositions(n),this}setColors(t){let e=t.length-3,n=new Float32Array(2*e);for(let s=0;s<e;s+=3)n[2*s]=t[s],n[2*s+1]=t[s+1],n[2*s+2]=t[s+2],n[2*s+3]=t[s+3],n[2*s+4]=t[s+4],n[2*s+5]=t[s+5];return super.setColors(n),this}setFromPoints(t){let e=t.length-1,n=new Float32Array(6*e);for(let s=0;s<e;s++)n[6*s]=t[s].x,n[6*s+1]=t[s].y,n[6*s+2]=t[s].z||0,n[6*s+3]=t[s+1].x,n[6*s+4]=t[s+1].y,n[6*s+5]=t[s+1].z||0;return super.setPositions(n),this}fromLine(t){let e=t.geometry;return this.setPositions(e.attributes.position.array),this}};var jl=class extends Br{constructor(t=new zr,e=new ys({color:Math.random()*16777215})){super(t,e),this.isLine2=!0,this.type="Line2"}};function og(i,t=Math.PI/3){let e=i.index?i.toNonIndexed():i,n=e.attributes.position,s=n.count,r;if(n.isBufferAttribute===!0&&n.itemSize===3&&n.normalized===!1)r=n.array;else{r=new Float64Array(s*3);for(let v=0;v<s;v++)r[3*v+0]=n.getX(v),r[3*v+1]=n.getY(v),r[3*v+2]=n.getZ(v)}let o=Math.cos(t),a=(1+1e-10)*100,c=s/3,l=new Float64Array(c*3);for(let v=0;v<c;v++){let A=9*v,w=r[A+0],_=r[A+1],M=r[A+2],C=r[A+3],T=r[A+4],L=r[A+5],N=r[A+6],F=r[A+7],P=r[A+8],B=N-C,G=F-T,H=P-L,j=w-C,W=_-T,Y=M-L,tt=G*Y-H*W,gt=H*j-B*Y,wt=B*W-G*j,X=1/(Math.sqrt(tt*tt+gt*gt+wt*wt)||1);l[3*v+0]=tt*X,l[3*v+1]=gt*X,l[3*v+2]=wt*X}let h=new Int32Array(s),u=new Float64Array(s*3),d=1;for(;d<s*2;)d<<=1;let f=d-1,p=new Int32Array(d),x=0;for(let v=0;v<s;v++){let A=3*v,w=Math.trunc(r[A+0]*a),_=Math.trunc(r[A+1]*a),M=Math.trunc(r[A+2]*a),C=(Math.imul(w,73856093)^Math.imul(_,19349663)^Math.imul(M,83492791))&f;for(;;){let T=p[C];if(T===0){let N=3*x;u[N+0]=w,u[N+1]=_,u[N+2]=M,p[C]=x+1,h[v]=x++;break}let L=3*(T-1);if(u[L+0]===w&&u[L+1]===_&&u[L+2]===M){h[v]=T-1;break}C=C+1&f}}let m=new Int32Array(x+1);for(let v=0;v<s;v++)m[h[v]+1]++;for(let v=0;v<x;v++)m[v+1]+=m[v];let g=new Int32Array(s),y=m.slice(0,x);for(let v=0;v<c;v++){let A=3*v;g[y[h[A+0]]++]=v,g[y[h[A+1]]++]=v,g[y[h[A+2]]++]=v}let S=new Float32Array(s*3);for(let v=0;v<c;v++){let A=3*v,w=l[A+0],_=l[A+1],M=l[A+2];for(let C=0;C<3;C++){let T=A+C,L=h[T],N=0,F=0,P=0;for(let G=m[L],H=m[L+1];G<H;G++){let j=3*g[G],W=l[j+0],Y=l[j+1],tt=l[j+2];w*W+_*Y+M*tt>o&&(N+=W,F+=Y,P+=tt)}let B=1/(Math.sqrt(N*N+F*F+P*P)||1);S[3*T+0]=N*B,S[3*T+1]=F*B,S[3*T+2]=P*B}}return e.setAttribute("normal",new De(S,3,!1)),e}var cg=new I(0,1,0),W1=.6,Ql=2*Math.PI,lg=(i,t,e)=>new ys({color:new zt(i),linewidth:t,transparent:e<1,opacity:e,alphaToCoverage:!1});function mn(i,t,e,n=1){let s=new jl(new zr,lg(t,e,n));return s.geometry.setPositions(i.length>3?i:[...i,...i]),s.frustumCulled=!1,s}var Gs=(i,t,e=1)=>hg(new pr,i,t,e);function hg(i,t,e,n){return i.geometry.setAttribute("position",new De(Float32Array.from(t),3)),i.material=new ji({color:e,transparent:n<1,opacity:n}),i.frustumCulled=!1,i}function ld(i,t){i.geometry.instanceCount=Math.max(0,t),i.visible=t>0}function kr(i,t,e,n=1){if(e<=1)return hg(new Is,i,t,n);let s=new Br(new _s,lg(t,e,n));return s.geometry.setPositions(i),s.frustumCulled=!1,s}var Gi=(i,t,e,n)=>i.joined?mn(t,e,n):ia(t,e,n);function Vi(i,t,e){i.joined?ld(t,e):t.geometry.setDrawRange(0,e+1)}function ia(i,t,e){let n=new Ee;n.setAttribute("position",new De(Float32Array.from(i),3));let s=new po(n,new mr({color:t,size:e,sizeAttenuation:!1}));return s.frustumCulled=!1,s}function vi(i,t,e,n=1){let s=[];for(let r=0;r<=128;r++)s.push(i*Math.cos(Ql*r/128),i*Math.sin(Ql*r/128),t);return n>1?mn(s,e,n):Gs(s,e)}function vs(i,t){let e=new Tn({color:i}),n=new ee(new Kn(t,t,1,16),e),s=new ee(new Qi(3*t,8*t,24),e),r=new ye().add(n,s);return r.point=(o,a)=>{let c=Math.max(a-8*t,1e-6);r.visible=a>.001,n.scale.set(1,c,1),n.position.set(0,.5*c,0),s.position.set(0,a-4*t,0),r.quaternion.copy(new ae().setFromUnitVectors(cg,o.clone().normalize())),r.userData.tip=o.clone().normalize().multiplyScalar(a)},r}function Ms(i,t,e){let n=new ee(new En(e,24,16),new hn({color:i})),s=new ee(new En(1.35*e,24,16),new hn({color:t,side:1}));return new ye().add(n,s)}function ug(i,t,e,n){let s=new ee(new Qi(.45*n,n,16),new hn({color:i}));return s.position.copy(t).multiplyScalar(1.003),s.quaternion.setFromUnitVectors(cg,e),s}var ag={stable:()=>new En(.045,20,14),unstable:()=>new _o(.06),undecided:()=>new Ni(.075,.075,.075)};function dg(i,t,e,n){let s=new ee(ag[t](),new hn({color:e})),r=new ee(ag[t](),new hn({color:n,side:1}));r.scale.setScalar(1.3);let o=new ye().add(s,r);return o.position.copy(i),o}function fg(i,t,e,n,s=null){let r=new Ee;if(r.setAttribute("position",new De(Float32Array.from(i),3)),r.setIndex(new De(t,1)),s){let l=[...s].flatMap(h=>new zt(h).toArray());r.setAttribute("color",new De(Float32Array.from(l),3))}let o=og(r,W1),a=new Tn({color:s?"#ffffff":e,vertexColors:!!s,side:2,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),c=new Is(new gr(r,30),new ji({color:n,transparent:!0,opacity:.6}));return new ye().add(new ee(o,a),c)}function pg(i,t,e){let n=new Ni(...i),s=new Tn({color:t,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),r=new Is(new gr(n),new ji({color:e,transparent:!0,opacity:.6}));return new ye().add(new ee(n,s),r)}function sa(i,t,e,n=1){let s=new Tn({color:t,transparent:n<1,opacity:n,polygonOffset:!0,polygonOffsetFactor:1,polygonOffsetUnits:1}),r=new ee(new En(1,80,48),s);r.scale.set(...i);let o=new ye().add(r);for(let a=0;a<3;a++){let c=[];for(let l=0;l<=128;l++){let h=[0,0,0];h[(a+1)%3]=i[(a+1)%3]*Math.cos(Ql*l/128),h[(a+2)%3]=i[(a+2)%3]*Math.sin(Ql*l/128),c.push(...h)}o.add(Gs(c,e,.7))}return o.userData.mesh=r,o}function Gr(i){let t=new Tn({color:i.sphere,transparent:!0,opacity:.8,depthWrite:!0}),e=new ee(new En(.995,80,48),t);return e.renderOrder=1,e}function Vr(i,t,e,n=4){let s=new Kn(i,i,1e-4,96);s.rotateX(Math.PI/2);let r=new hn({color:e.plane,transparent:!0,opacity:.75,polygonOffset:!0,polygonOffsetFactor:2,polygonOffsetUnits:2}),o=new ee(s,r),a=new ye().add(o);for(let c=1;c<=n;c++)a.add(vi(i*c/n,0,e.ring));return a.position.set(0,0,t),a.userData.mesh=o,a}function mg(i){i.traverse(t=>{t.geometry?.dispose();for(let e of[t.material].flat())e?.dispose()})}var q1=17,X1=200,$1=2,th=class{constructor(t){this.view=t,this.renderer=new fl({antialias:!0,alpha:!0,powerPreference:"low-power"}),this.renderer.setClearColor(0,0),this.size=[0,0]}draw(t,e,n){let s=Math.min(window.devicePixelRatio||1,$1),r=e.map(c=>[c.clientWidth,c.clientHeight]);this.fit(r.reduce((c,[l])=>c+l,0),Math.max(...r.map(([,c])=>c)),s);let o=0,a=t.map((c,l)=>{let[h,u]=r[l];return h&&u&&this.render(c,o,h,u),o+=h,o-h});t.forEach((c,l)=>this.copy(c,e[l],a[l],r[l],s,n))}render(t,e,n,s){let{renderer:r}=this;t.flat?J1(t.camera,t.flat,n/s):this.view.place(t.camera,t.target??Pu,t.radius,n/s),t.lamp.position.copy(t.camera.position).add(K1.clone().applyQuaternion(t.camera.quaternion)),t.lamp.target.position.copy(t.target??Pu),t.lamp.target.updateMatrixWorld(),r.setViewport(e,0,n,s),r.setScissor(e,0,n,s),r.setScissorTest(!0),r.render(t.scene,t.camera)}copy(t,e,n,[s,r],o,a){let[c,l]=[Math.round(s*o),Math.round(r*o)];if(!c||!l)return;(e.width!==c||e.height!==l)&&([e.width,e.height]=[c,l]);let h=e.getContext("2d"),u=this.renderer.domElement;h.clearRect(0,0,c,l),h.drawImage(u,n*o,u.height-l,c,l,0,0,c,l),this.write(t,h,c,l,o,a)}fit(t,e,n){let s=[Math.max(this.size[0],t),Math.max(this.size[1],e)];this.dots===n&&s[0]===this.size[0]&&s[1]===this.size[1]||([this.size,this.dots]=[s,n],this.renderer.setPixelRatio(n),this.renderer.setSize(...s,!1))}write(t,e,n,s,r,o){if(t.boxes=[],Math.min(n,s)<X1*r)return;e.font=`600 ${13*r}px system-ui, sans-serif`,e.textAlign="center",e.textBaseline="middle",e.lineJoin="round";let a=[];for(let{text:c,place:l,color:h}of t.labels()){let u=l.clone().project(t.camera),d=[e.measureText(c).width+4*r,q1*r],f=[.5*(1+u.x)*n,.5*(1-u.y)*s],p=Z1(f,d,a,[n,s]);a.push(p);let[x,m]=[p[0]+.5*d[0],p[1]+.5*d[1]];e.lineWidth=4*r,e.strokeStyle=o.ground,e.strokeText(c,x,m),e.fillStyle=h,e.fillText(c,x,m)}t.boxes=a.map(c=>c.map(l=>l/r))}},gg=[[0,0],[1,0],[-1,0],[0,-1],[0,1],[1,-1],[-1,-1],[1,1],[-1,1]],Y1=4;function Z1([i,t],[e,n],s,[r,o]){let a=(h,u,d)=>Math.min(Math.max(h,0),Math.max(0,d-u)),c=([h,u])=>s.every(([d,f,p,x])=>h>=d+p||d>=h+e||u>=f+x||f>=u+n),l=null;for(let h=0;h<=Y1;h++)for(let[u,d]of h?gg.slice(1):gg.slice(0,1)){let f=a(i-.5*e+h*u*.55*e,e,r),p=a(t-.5*n+h*d*.55*n,n,o);if(l??=[f,p],c([f,p]))return[f,p,e,n]}return[...l,e,n]}function J1(i,{wide:t,high:e,x:n=0},s){let r=Math.max(e,t/s)/Math.tan(_l*Math.PI/360);i.position.set(n,0,r),i.up.set(0,1,0),i.aspect=s,i.near=r/2,i.far=2*r,i.lookAt(n,0,0),i.updateProjectionMatrix(),i.updateMatrixWorld()}var K1=new I(-2,3,1);function In(i,t){let e=new co,n=new wo(16777215,2.1*i.lamp);return e.add(new Ao(16777215,1.3*i.lamp),n,n.target),{scene:e,lamp:n,camera:Ip(),radius:1.5,labels:()=>[],probe:()=>({}),...t}}function xg(i,t,e){let n=t.center?"from the pivot towards the centre of mass":"third principal axis",s=In(e,{title:"Path of the axis",words:n,radius:1.4,target:new I(0,0,.12)}),{scene:r}=s,o=new I(...t.axis),a=i.solver?.nutationLimits??null,c=a?a.filter(p=>p!==null&&Math.abs(p)<1):t.limits;r.add(Gr(e),vi(1,0,e.family));for(let p of c)r.add(vi(Math.sqrt(Math.max(0,1-p*p)),p,e.border,1.5));let l=new Float64Array(3*i.count);for(let p=0;p<i.count;p++)o.clone().applyQuaternion(i.attitude(p)).toArray(l,3*p);let h=Gi(i,l,e.motion,2.6),u=i.joined?Gs(l,e.motion,.35):null,d=Ms(e.motion,e.ground,.035),f=vs(e.momentum,.012);return f.position.set(0,0,1),f.point(new I(0,0,1),.32),r.add(h,d,f),u&&r.add(u),s.legend=[{color:e.motion,text:"axis"},...c.length?[{color:e.border,text:"limits of its tilt"}]:[]],s.update=p=>{d.position.copy(o).applyQuaternion(p.attitude),Vi(i,h,Math.floor(p.position))},s.labels=()=>[{text:"up",color:e.momentum,place:new I(0,0,1.42)}],s.probe=()=>({point:d.position.toArray(),path:[...l],limits:c}),s}var[_g,j1,Q1]=[.45,.14,1.2],hd=6,tA=.45,yg=new I(0,1,0);function vg(i,t,e){let n=new I(...i.solver?.axis||t.axis).normalize(),s=new ye;for(let d=0;d<hd;d++){let f=new Kn(_g,_g,j1,12,1,!1,2*Math.PI*d/hd,2*Math.PI/hd),p=new Tn({color:e.rotor});d%2&&p.color.multiplyScalar(tA),s.add(new ee(f,p))}let r=new ae().setFromUnitVectors(yg,n),o=n.clone().multiplyScalar(Q1).toArray(),a=new ye().add(s,mn([...o.map(d=>-d),...o],e.rotor,2)),c=eA(i,t),l=c&&nA(i.times,c),h=(d,{position:f})=>{let p=Math.min(Math.floor(f),d.length-2);return p<0?d[0]:d[p]+(f-p)*(d[p+1]-d[p])};return{object:a,turn:d=>{let f=l?h(l,d):0;s.quaternion.copy(r).multiply(new ae().setFromAxisAngle(yg,f))},rate:d=>c?h(c,d):null}}function eA(i,t){let e=i.solver;if(!e?.rotorRate)return ue(t.rates);if(e.rotorMoment===null)return null;let n=s=>[0,1,2].map(r=>i.velocities[3*s+r]);return Float64Array.from({length:i.count},(s,r)=>e.rotorRate(n(r))??0)}function nA(i,t){let e=new Float64Array(t.length);for(let n=1;n<t.length;n++)e[n]=e[n-1]+.5*(t[n]+t[n-1])*(i[n]-i[n-1]);return e}var Ss=1.32,iA={ground:0,post:-Ss,hook:Ss},sA=.4,rA=1.5,oA=.35,aA=.06;function Sg(i,t,e){let n=t.pivot&&i.solver?{...t,pivot:hA(i,t.pivot)}:t,s=In(e,{title:"The body in space",words:n.changed?"box or ellipsoid of the same inertia":n.shape,radius:n.pivot==="ground"?1.7:1.88});n.pivot||(s.target=new I(0,0,.08)),n.pivot==="ground"&&(s.target=new I(0,0,.5));let r=new ye;r.quaternion.copy(i.space),s.scene.add(r);let o=uA(i,n,e);r.add(o);let a=n.rotor?vg(i,n.rotor,e):null;a&&(cA(o),o.add(a.object));let c=[0,1,2].map(x=>{let m=new I().setComponent(x,Ss);return o.add(mn([0,0,0,...m.toArray()],e.axes[x],x===n.traced&&!n.along?2.5:1.5)),m}),l=e.axes[n.traced],u=(n.along?new I(...n.along):new I().setComponent(n.traced,1)).multiplyScalar(Ss);n.along&&o.add(mn([0,0,0,...u.toArray()],l,2.5));let d=fA(i,u,l);r.add(d.object),n.pivot?s.scene.add(Vr(n.pivot==="ground"?Ss:.7,iA[n.pivot],e)):s.scene.add(vi(Ss,0,e.ring)),n.pivot==="post"&&s.scene.add(mn([0,0,-Ss,0,0,0],e.edge,5)),n.pivot==="hook"&&s.scene.add(mn([0,0,0,0,0,Ss],e.edge,5));let f={L:i.momenta&&vs(e.momentum,.02),\u03A9:i.velocities&&vs(e.velocity,.017)};for(let x of Object.values(f))x&&r.add(x);let p=null;return s.legend=[{color:l,text:n.along?"trace of the axis through the centre of mass":`trace of axis ${n.axes?.[n.traced]??n.traced+1}`},...f.L?[{color:e.momentum,text:"L"}]:[],...f.\u03A9?[{color:e.velocity,text:"\u03A9"}]:[],...a?[{color:e.rotor,text:`rotor${lA(a.rate({position:0}))}`}]:[]],s.update=x=>{p=x,o.quaternion.copy(x.attitude),d.show(x.position),a?.turn(x),Mg(f.L,x.momentum,x.attitude,pA(i.momenta)),Mg(f.\u03A9,x.velocity,x.attitude,i.fastest)},s.labels=()=>[...c.map((x,m)=>({text:n.axes?.[m]??`${m+1}`,color:e.axes[m],place:x.clone().multiplyScalar(1.07).applyQuaternion(p.attitude).applyQuaternion(i.space)})),...Object.entries(f).filter(([,x])=>x?.visible).map(([x,m])=>({text:x,color:x==="L"?e.momentum:e.velocity,place:m.userData.tip.clone().multiplyScalar(x==="L"?1.08:1.16).applyQuaternion(i.space)}))],s.probe=()=>(o.updateWorldMatrix(!0,!1),{matrix:[...o.matrixWorld.elements],axisTip:u.clone().applyMatrix4(o.matrixWorld).toArray(),trace:[...d.points].slice(0,3*(d.shown+1)),momentumTip:f.L?.userData.tip?.toArray()??null,rotor:a?[...a.object.children[0].quaternion.toArray(),a.rate(p)]:null}),s}function cA(i){i.traverse(t=>{t.isMesh&&(Object.assign(t.material,{transparent:!0,opacity:oA,depthWrite:!1}),t.renderOrder=1)})}function lA(i){return i===null?", drawn at rest: its moment is not given":`, ${$t(i*30/Math.PI,4)} rpm against the body`}function hA(i,t){let e=[];for(let n=0;n<i.count;n++)e.push(new I(0,0,1).applyQuaternion(i.attitude(n)).z);return e.reduce((n,s)=>n+s,0)<0?"hook":t!=="ground"||Math.min(...e)<sA?"post":"ground"}function uA(i,t,e){let n=new ye,s=t.changed&&i.free?dA(i.free):null;if(s&&t.round)return n.add(sa(s.map(r=>.5*r),e.body,e.edge));if(t.changed&&!s&&i.moments&&(t={ellipsoid:i.moments.map(r=>1/Math.sqrt(r))}),s)return n.add(pg(s,e.body,e.edge));if(t.surface){let r=ue(t.surface.vertices),o=0;for(let c=0;c<r.length;c+=3)o=Math.max(o,Math.hypot(r[c],r[c+1],r[c+2]));let a=ue(t.surface.colors);n.add(fg(r.map(c=>c/o),ue(t.surface.faces),e.body,e.edge,a))}else if(t.ellipsoid){let r=Math.max(...t.ellipsoid);n.add(sa(t.ellipsoid.map(o=>o/r),e.body,e.edge))}return n}function dA([i,t,e]){let n=[t+e-i,e+i-t,i+t-e],s=i+t+e;return n.some(r=>r<1e-9*s)?null:n.map(r=>2*Math.sqrt(r/s))}function fA(i,t,e){let n=[],s=[],r=c=>n.push(...t.clone().applyQuaternion(c).toArray()),o=null;for(let c=0;c<i.count;c++){let l=i.attitude(c);if(o&&i.joined){let h=Math.min(20,Math.ceil(o.angleTo(l)/aA));for(let u=1;u<h;u++)r(i.at(c-1+u/h).attitude)}r(l),s.push(n.length/3-1),o=l}let a={points:n,shown:0};return i.joined?(a.object=mn(n,e,2),a.show=c=>ld(a.object,a.shown=s[Math.floor(c)])):(a.object=ia(n,e,3),a.show=c=>a.object.geometry.setDrawRange(0,(a.shown=Math.floor(c))+1)),a}function Mg(i,t,e,n){if(!i)return;let s=n?t.length()/n:0;s>0?i.point(t.clone().applyQuaternion(e),rA*s):i.visible=!1}function pA(i){let t=0;for(let e=0;i&&e<i.length;e+=3)t=Math.max(t,Math.hypot(i[e],i[e+1],i[e+2]));return t}function bg(i,t,e){let n=i.at(0).momentum,{free:s}=i;if(!(n.length()>0))return In(e,{title:"Poinsot's ellipsoid",words:"at rest",update:()=>{},legend:[]});let r=.5*n.toArray().reduce((T,L,N)=>T+L*L/s[N],0),o=s.map(T=>1/Math.sqrt(T)),a=1/Math.max(...o),c={moments:s,energy:r},l=a*Math.sqrt(2*r)/n.length(),h=gA(i,c,a),u=Math.max(1.25*mA(h,l),.9),d=1.3,f=.5*(d-l),p=In(e,{title:"Poinsot's ellipsoid",words:"rolls without slipping on the plane across L",radius:Math.hypot(Math.max(u,1),d-f)*1.04,target:new I(0,0,f)}),x=new ye;x.quaternion.copy(i.space);let m=sa(o.map(T=>T*a),e.body,e.edge,.82);x.add(m);let g=Vr(u,-l,e);p.scene.add(x,g);let y=xA(i,h),S=Gi(i,h,e.motion,3),v=Gi(i,y,e.border,2.5);m.add(S),x.add(v),i.joined&&x.add(Gs(y,e.border,.45));let A=Ms(e.velocity,e.ground,.03),w=vs(e.velocity,.012),_=vs(e.momentum,.012),M=Gs([0,0,-l,0,0,0],e.edge);x.add(A,w),p.scene.add(_,M),_.point(new I(0,0,1),d);let C=0;return p.legend=[{color:e.motion,text:"polhode"},{color:e.border,text:"herpolhode"},{color:e.velocity,text:"contact, \u2212\u03A9"}],p.update=T=>{let L=Math.floor(T.position*i.fine);m.quaternion.copy(T.attitude),A.position.copy(wg(T.momentum,c,a)).applyQuaternion(T.attitude),w.point(A.position,A.position.length()),Vi(i,S,L),Vi(i,v,L),C=L},p.labels=()=>[{text:"L",color:e.momentum,place:new I(0,0,d+.12)}],p.probe=()=>{for(let T of[m,g,A])T.updateWorldMatrix(!0,!0);return{ellipsoid:[...m.userData.mesh.matrixWorld.elements],plane:[...g.matrixWorld.elements],contact:new I().setFromMatrixPosition(A.matrixWorld).toArray(),bodyMatrix:[...m.matrixWorld.elements],spaceMatrix:[...x.matrixWorld.elements],polhode:[...h],herpolhode:[...y],shown:C/i.fine}},p}function wg(i,{moments:t,energy:e},n){let s=-n/Math.sqrt(2*e);return new I(...i.toArray().map((r,o)=>s*r/t[o]))}function mA(i,t){let e=0;for(let n=0;n<i.length;n+=3)e=Math.max(e,Math.hypot(i[n],i[n+1],i[n+2]));return Math.sqrt(Math.max(0,e*e-t*t))}function gA(i,t,e){let n=new Float64Array(3*i.states.length);return i.states.forEach(({momentum:s},r)=>wg(s,t,e).toArray(n,3*r)),n}function xA(i,t){let e=new Float64Array(t.length);return i.states.forEach(({attitude:n},s)=>{new I().fromArray(t,3*s).applyQuaternion(n).toArray(e,3*s)}),e}var _A=18,Ag=4,Eg={stable:"stable",unstable:"border",undecided:"family"},yA={stable:"stable",unstable:"unstable",undecided:"undecided"};function Tg(i,t,e){let n=In(e,{title:t.title,words:t.words,radius:1.36}),{scene:s}=n,r=t.families?e.text:e.motion;s.add(Gr(e));let o=i.free?i.at(0).momentum.toArray():null,[a,c]=o?[t.families?[]:im(i.free),sm(i.free)]:t.changed&&i.solver?[rm(i.moments,i.solver.rotor??[0,0,0],i.at(0).momentum.length()),[]]:[ue(t.family)??[],ue(t.separatrix)??[]];a.length&&s.add(kr(a,e.family,1));for(let{starts:m,axis:g}of t.families??[])s.add(kr(m.flatMap(y=>Yo(i.free,y)),e.axes[g],1,.75));c.length&&s.add(kr(c,e.border,1.8));let l=o&&Math.hypot(...o)>0?zs(i.free,o):null,h=l??vA(i),u=l?mn(l,r,3.2):Gi(i,h,r,2);if(s.add(u),l)for(let m of MA(i.free,l,r))s.add(m);let d=Ms(r,e.ground,.035);s.add(d);let f=[0,1,2].map(m=>{let g=new I().setComponent(m,1.2);return s.add(mn([...new I().setComponent(m,1).toArray(),...g.toArray()],e.axes[m],2.5)),g}),p=i.free?nm(i.free):t.equilibria??[];for(let{at:m,verdict:g}of p)s.add(dg(new I(...m),g,e[Eg[g]],e.ground));let x=[...new Set(p.map(({verdict:m})=>m))];return n.legend=[{color:r,text:"this motion"},...c.length?[{color:e.border,text:"separatrix"}]:[],...a.length?[{color:e.family,text:t.legend}]:[],...(t.families??[]).map(({axis:m,legend:g})=>({color:e.axes[m],text:g})),...x.map(m=>({color:e[Eg[m]],text:yA[m]}))],n.update=m=>{let g=m.momentum.length();d.visible=g>0,g>0&&d.position.copy(m.momentum).divideScalar(g),l||Vi(i,u,Math.floor(m.position*i.fine))},n.labels=()=>f.map((m,g)=>({text:t.axes?.[g]??`L${"\u2081\u2082\u2083"[g]}`,color:e.axes[g],place:m.clone().multiplyScalar(1.08)})),n.grasp=([m,g],y)=>{let S=d.position.clone().project(n.camera),v=d.position.dot(n.camera.position)>1;return i.free&&v&&Math.hypot(S.x-m,S.y-g)*.5*y<_A},n.under=m=>SA(m,n.camera),n.probe=()=>({point:d.position.toArray(),path:[...h],closed:!!l,seen:d.position.clone().project(n.camera).toArray()}),n}function vA(i){let t=new Float64Array(3*i.states.length);return i.states.forEach(({momentum:e},n)=>e.clone().normalize().toArray(t,3*n)),t}function MA(i,t,e){let n=[],s=t.length/3-1;for(let r=0;r<Ag;r++){let o=new I().fromArray(t,3*Math.round((r+.5)/Ag*s)),a=o.clone().cross(new I(...o.toArray().map((c,l)=>c/i[l])));a.length()>0&&n.push(ug(e,o,a.normalize(),.085))}return n}function SA([i,t],e){let n=e.position.clone(),s=new I(i,t,.5).unproject(e).sub(n).normalize(),r=-n.dot(s),o=n.clone().addScaledVector(s,r),a=o.lengthSq();return a>=1?o.lengthSq()>0?o.normalize().toArray():null:n.addScaledVector(s,r-Math.sqrt(1-a)).normalize().toArray()}var bA=1600,wA=.05,ge={left:62,right:12,top:10,bottom:24},Hr=180/Math.PI,Rg=[[1/Hr,"\xB0"],[1/Hr/60,"\u2032"],[1/Hr/3600,"\u2033"],[.001/Hr/3600,"mas"]];function AA(i,t,e,n){let s=i.solver?.plots?.(n.map(h=>i.times[h])),r=[e.motion,e.border,e.stable];if(s)return s.map(({series:h,along:u,...d})=>({...d,series:h.map((f,p)=>({...f,color:(u?e.axes:r)[p]}))}));let o=[],a=i.velocities??i.momenta,c=t.axes??["axis 1","axis 2","axis 3"];a&&o.push({title:i.velocities?"\u03A9 along the body's axes":"L along the body's axes",unit:i.velocities?"rad/s":"kg m\xB2/s",series:c.map((h,u)=>({name:h,color:e.axes[u],values:n.map(d=>a[3*d+u])}))});let l=EA(i,t,e,n,c);l&&o.push(l);for(let{title:h,unit:u,series:d}of t.plots??[])o.push({title:h,unit:u,series:d.map(({name:f,values:p},x)=>{let m=ue(p);return{name:f,color:r[x%r.length],values:n.map(g=>m[g])}})});return o}function EA(i,t,e,n,s){if(!i.attitudes)return null;if(t.up==="L"&&i.momenta){let a=(l,h)=>{let u=i.momenta.subarray(3*l,3*l+3);return Math.atan2(Math.hypot(u[(h+1)%3],u[(h+2)%3]),u[h])*Hr};return{title:"angles of the axes from L",unit:"\xB0",series:s.map((l,h)=>({name:l,color:e.axes[h],values:n.map(u=>a(u,h))}))}}let r=new I(...t.panels.find(a=>a.axis)?.axis??[0,0,1]).normalize(),o=a=>{let[c,l,h,u]=i.attitudes.subarray(4*a,4*a+4),d=r.clone().applyQuaternion(new ae(l,h,u,c));return Math.atan2(Math.hypot(d.x,d.y),d.z)*Hr};return{title:"tilt of the axis from the vertical",unit:"\xB0",series:[{name:"tilt",color:e.motion,values:n.map(o)}]}}var eh=class{constructor(t,e){this.root=t,this.goTo=e,this.plots=[]}take(t,e,n){this.motion=t,this.theme=n;let s=Math.max(1,Math.ceil(t.count/bA)),r=[];for(let c=0;c<t.count;c+=s)r.push(c);r.at(-1)!==t.count-1&&r.push(t.count-1),this.times=r.map(c=>t.times[c]);let o=t.count>1&&t.span>0?AA(t,e,n,r).map(IA):[];for(let{title:c,words:l,x:h,y:u}of e.scatters??[])o.push({title:c,words:l,scatter:[ue(h),ue(u)],color:n.motion});let a=TA(t,n);a&&o.push(a),o.length!==this.plots.length&&(this.root.replaceChildren(...o.map(()=>this.frame())),this.plots=o.map((c,l)=>({figure:this.root.children[l],canvas:this.root.children[l].firstChild}))),this.plots.forEach((c,l)=>{c.what=o[l],c.still=null,PA(c.figure,o[l])})}frame(){let t=document.createElement("figure");t.className="plot";let e=document.createElement("canvas");e.setAttribute("role","img");let n=s=>{if(!this.plots.find(c=>c.canvas===e).what.series||s.type==="pointermove"&&!s.buttons)return;let o=e.getBoundingClientRect(),a=(s.clientX-o.left-ge.left)/(o.width-ge.left-ge.right);this.goTo(this.times[0]+Math.min(1,Math.max(0,a))*(this.times.at(-1)-this.times[0]))};return e.addEventListener("pointerdown",n),e.addEventListener("pointermove",n),t.append(e,document.createElement("figcaption")),t}draw(t){for(let e of this.plots){let{canvas:n,what:s}=e,r=Math.min(window.devicePixelRatio||1,2),[o,a]=[n.clientWidth,n.clientHeight];if(!o||!a)continue;(!e.still||e.width!==o||e.dots!==r)&&(Object.assign(e,{width:o,dots:r,still:this.still(s,o,a,r)}),[n.width,n.height]=[e.still.width,e.still.height]);let c=n.getContext("2d");c.clearRect(0,0,n.width,n.height),c.drawImage(e.still,0,0),c.setTransform(r,0,0,r,0,0),s.path?this.dot(c,s,t,o,a):s.series&&this.cursor(c,t,o,a),c.setTransform(1,0,0,1,0,0)}}still(t,e,n,s){let r=document.createElement("canvas");[r.width,r.height]=[Math.round(e*s),Math.round(n*s)];let o=r.getContext("2d");return o.scale(s,s),o.font="12px system-ui, sans-serif",t.path?CA(o,t,e,n,this.theme):t.scatter?RA(o,t,e,n,this.theme):this.drawCurves(o,t,e,n),r}drawCurves(t,{series:e,unit:n,power:s},r,o){let{times:a,theme:c}=this,[l,h]=ud(e),u=Pg(a[0],a.at(-1),l,h,r,o);t.fillStyle=c.text,t.strokeStyle=c.ring,t.textBaseline="middle",t.textAlign="right";for(let x of nh(l,h,4)){let[,m]=u(a[0],x);Wr(t,[[ge.left,m],[r-ge.right,m]]),t.fillText(`${ra(x/10**s)}${n==="\xB0"?"\xB0":""}`,ge.left-6,m)}t.textBaseline="top",t.textAlign="center";let d=a.at(-1)-a[0],[f,p]=Vu(d)??[1,"s"];for(let x of nh(a[0]/f,a.at(-1)/f,r>500?6:3))t.fillText(`${ra(x)} ${p}`,u(x*f,l)[0],o-ge.bottom+7);for(let{color:x,values:m,times:g=a}of e){[t.strokeStyle,t.fillStyle,t.lineWidth]=[x,x,1.6];let y=m.map((S,v)=>u(g[v],S));if(this.motion.joined)Wr(t,y);else for(let[S,v]of y)t.fillRect(S-1,v-1,2,2)}}cursor(t,e,n,s){let[r,o]=[this.times[0],this.times.at(-1)],a=ge.left+(e.time-r)/(o-r||1)*(n-ge.left-ge.right);t.strokeStyle=this.theme.text,t.lineWidth=1.2,Wr(t,[[a,ge.top],[a,s-ge.bottom]])}dot(t,e,n,s,r){let[o,a]=Cg(e,s,r)(e.flat(n.momentum.clone().normalize()));t.fillStyle=this.theme.velocity,t.beginPath(),t.arc(o,a,5,0,2*Math.PI),t.fill()}probe(){return this.plots.map(({what:t})=>({title:t.title,ranges:(t.series??[]).map(({values:e})=>[Math.min(...e),Math.max(...e)]),across:t.across??null}))}};function TA(i,t){if(!i.free)return null;let e=i.at(0).momentum;if(!(e.length()>0))return null;let n=zs(i.free,e.toArray()),s=e.clone().normalize().toArray(),r=s.reduce((f,p,x)=>Math.abs(p)>Math.abs(s[f])?x:f,0);if(!n)return null;let o=Math.sign(s[r]),a=f=>[f.getComponent((r+1)%3)*o,f.getComponent((r+2)%3)],c=[];for(let f=0;f<n.length;f+=3)c.push(a(new I(n[f],n[f+1],n[f+2])));let l=Math.max(...c.map(([f,p])=>Math.hypot(f,p)));if(!(l<wA)||l<1e-14)return null;let[h,u]=Rg.find(([f])=>2*l>=f)??Rg.at(-1),d=`${ra(2*l/h,3)}${u.length>1?" ":""}${u}`;return{title:`the polhode from above, ${d} across: the sphere magnified ${$t(1/l,1)} times`,across:d,path:c,flat:a,most:l,color:t.motion,unit:h,name:u}}var Cg=({most:i},t,e)=>{let n=(.5*Math.min(t,e)-22)/i;return([s,r])=>[.5*t+n*s,.5*e-n*r]};function RA(i,{scatter:[t,e],color:n},s,r,o){let[[a,c],[l,h]]=[t,e].map(f=>ud([{values:f}])),u=Pg(a,c,l,h,s,r);[i.fillStyle,i.textBaseline,i.textAlign]=[o.text,"middle","right"];for(let f of nh(l,h,4))i.fillText(ra(f),ge.left-6,u(a,f)[1]);[i.textBaseline,i.textAlign]=["top","center"];for(let f of nh(a,c,6))i.fillText(ra(f),u(f,l)[0],r-ge.bottom+7);i.strokeStyle=o.ring,i.strokeRect(ge.left,ge.top,s-ge.left-ge.right,r-ge.top-ge.bottom),i.fillStyle=n;let d=t.length<500?3:1.6;for(let f=0;f<t.length;f++){let[p,x]=u(t[f],e[f]);i.fillRect(p-.5*d,x-.5*d,d,d)}}function CA(i,t,e,n,s){let r=Cg(t,e,n);i.strokeStyle=s.ring,Wr(i,[[.5*e-8,.5*n],[.5*e+8,.5*n]]),Wr(i,[[.5*e,.5*n-8],[.5*e,.5*n+8]]),[i.strokeStyle,i.lineWidth]=[t.color,2],Wr(i,t.path.map(r))}function PA(i,{title:t,words:e="",unit:n,series:s,path:r,power:o}){let a=document.createElement("strong"),c=o?`10${[...String(o)].map(d=>Gu[d]).join("")} `:"";a.textContent=n&&!r?`${t} [${c}${n}]`:t;let l=document.createElement("span");l.className="legend";for(let{name:d,color:f}of s?.length>1?s:[]){let[p,x]=[document.createElement("span"),document.createElement("i")];x.style.background=f,p.append(x,d),l.append(p)}let h=document.createElement("span");h.className="words",h.textContent=e,i.lastChild.replaceChildren(a,h,l);let u=r?", with the point that moves":s?", over time":"";i.firstChild.setAttribute("aria-label",`${a.textContent}${e?`, ${e}`:""}${u}.`)}function IA(i){let t=Math.max(...ud(i.series).map(Math.abs)),e=i.unit==="\xB0"||!(t>0)||t>=.01&&t<1e4;return{...i,power:e?0:Math.floor(Math.log10(t))}}var ra=(i,t=6)=>String(Number(i.toPrecision(t))).replace("-","\u2212");function ud(i){let[t,e]=[1/0,-1/0];for(let{values:s}of i)for(let r of s)t=Math.min(t,r),e=Math.max(e,r);let n=e-t>1e-9*Math.max(Math.abs(t),Math.abs(e))?.06*(e-t):.5*Math.abs(e)||1;return[t-n,e+n]}function Pg(i,t,e,n,s,r){let[o,a]=[s-ge.left-ge.right,r-ge.top-ge.bottom];return(c,l)=>[ge.left+(c-i)/(t-i||1)*o,ge.top+(n-l)/(n-e)*a]}function nh(i,t,e){let n=(t-i)/e,s=10**Math.floor(Math.log10(n)),r=[1,2,5,10].find(a=>a*s>=n)*s,o=[];for(let a=Math.ceil(i/r);a*r<=t;a++)o.push(a*r);return o}function Wr(i,t){i.beginPath(),t.forEach(([e,n],s)=>s?i.lineTo(e,n):i.moveTo(e,n)),i.stroke()}var oa=i=>document.getElementById(i),ih=class{constructor(t,e,n){this.presets=t,this.act=n,oa("playground").hidden=!1,document.documentElement.dataset.playground="",this.buttons=t.map((s,r)=>{let o=document.createElement("button");return Object.assign(o,{type:"button",textContent:s.title}),o.addEventListener("click",()=>e(this.choose(r))),o}),oa("presets").replaceChildren(...this.buttons)}find(t){let e=this.presets.findIndex(({key:o})=>o===t),n=this.choose(Math.max(0,e)),[s,r]=[oa("presets"),this.buttons[Math.max(0,e)]];return s.scrollLeft+=r.getBoundingClientRect().left-.5*(s.clientWidth-r.offsetWidth),t&&e<0&&this.tell(`The playground has no motion called ${t}; it has ${this.presets.map(({key:o})=>o).join(", ")}.`),n}tell(t){let e=document.createElement("li");e.textContent=t,oa("story").prepend(e)}choose(t){return this.buttons.forEach((e,n)=>e.setAttribute("aria-pressed",String(n===t))),oa("story").replaceChildren(...this.presets[t].story.map(e=>this.sentence(e))),this.presets[t]}sentence(t){let e=document.createElement("li"),[,n,s,r]=/^(.*?)\[(.+?)\](.*)$/s.exec(t.say)??[null,`${t.say} `,t.set&&(t.label??"Show it"),""];if(e.append(n),!s)return e;let o=document.createElement("button");return Object.assign(o,{type:"button",textContent:s}),o.addEventListener("click",()=>this.act(t)),o.addEventListener("pointerup",()=>o.blur()),e.append(o,r),e}};var LA={momentum_norm:"|L|",momentum_space:"L in space","|L|\xB2":"|L|\xB2"},sh=class{constructor(t,e,n){this.list=t,this.take(e,n)}take(t,e,n=!1){this.data=e,this.rows={},this.list.replaceChildren();for(let[a,c]of[...t.energies?[["energy",e.energyName]]:[],...t.momenta?[["momentum","|L|"]]:[],...t.velocities?[["velocity","|\u03A9|"]]:[]])this.rows[a]=this.row(c);let s=Object.entries(e.drift);if(!s.length||n)return;let r=s.reduce((a,c)=>c[1]>a[1]?c:a),o=(LA[r[0]]??r[0]).replaceAll("_"," ");this.row("largest drift").textContent=`${$t(r[1],2)} (${o})`}row(t){let[e,n]=[document.createElement("dt"),document.createElement("dd")];e.textContent=t;let s=document.createElement("div");return s.append(e,n),this.list.append(s),n}show(t){let e=(r,o)=>{this.rows[r]&&this.rows[r].textContent!==o&&(this.rows[r].textContent=o)},{energy:n=[1,this.data.energyUnit],momentum:s=[1,"kg m\xB2/s"]}=this.data.units??{};t.energy!==null&&e("energy",`${$t(t.energy/n[0])} ${n[1]}`),t.momentum&&e("momentum",`${$t(t.momentum.length()/s[0])} ${s[1]}`),t.velocity&&e("velocity",`${$t(t.velocity.length(),5)} rad/s`)}};var NA=[["video/webm;codecs=vp9","webm"],["video/webm;codecs=vp8","webm"],["video/webm","webm"],["video/mp4","mp4"]];var Ig=()=>typeof MediaRecorder<"u"&&typeof HTMLCanvasElement.prototype.captureStream=="function"&&!!Lg(),Lg=()=>NA.find(([i])=>MediaRecorder.isTypeSupported(i)),rh=class{constructor(t,e,n){let[s,r]=Lg();this.canvas=t,this.begun=performance.now();let o=[],a=t.captureStream(30);this.recorder=new MediaRecorder(a,{mimeType:s,videoBitsPerSecond:8e6}),this.recorder.addEventListener("dataavailable",({data:c})=>c.size&&o.push(c)),this.recorder.addEventListener("stop",()=>{for(let c of a.getTracks())c.stop();n(o.length?new Blob(o,{type:s}):null,r)}),this.recorder.start(),this.waiting=setTimeout(()=>this.close(),1e3*e)}get passed(){return(performance.now()-this.begun)/1e3}paint(t){this.draw=t,t(this.canvas)}close(){this.draw?.(this.canvas),this.waiting=setTimeout(()=>this.stop(),3e3/30)}stop(){clearTimeout(this.waiting),this.recorder.state!=="inactive"&&this.recorder.stop()}};var DA=760,[dd,UA,fd]=[.5,10,60],Ln=i=>document.getElementById(i),oh=class{constructor(t){this.page=t;let e=(n,s)=>Ln(n).addEventListener("click",s);e("link",()=>this.copyLink()),e("embed",()=>this.copyEmbedCode()),e("spec",()=>this.copySpec()),e("picture",()=>this.savePicture()),e("film",()=>this.film?this.film.stop():this.saveFilm()),Ln("film-length").addEventListener("change",()=>this.check())}take(){Ln("spec").hidden=!this.page.instrument?.kind.toml;for(let t of["copied","saved"])Ln(t).hidden=!0;this.say(""),this.given=null,this.suggest()}say(t){Ln("shared").textContent=t}async copy(t,e){let n=Ln("copied");n.value=t,n.hidden=!1;try{await navigator.clipboard.writeText(t),this.say(e)}catch{this.say("This browser keeps the clipboard from pages in frames: copy the text from the field below."),n.select()}}copyLink(){let{whole:t,fragment:e}=this.page.address;if(t===null)return this.copy(`#${e}`,"A page in a notebook has no address of its own. Write it to a file with write_page, and add this to the file's address.");let n=t.startsWith("file:")?" It opens on this computer only: put the file on a web server to give it to others.":"";return this.copy(t,`The link is copied.${n}`)}copyEmbedCode(){let{whole:t}=this.page.address;if(t===null)return this.say("A page in a notebook has no address that another page could embed. Write it to a file with write_page, and put the file on a web server.");let e=`polhode: ${Ln("name").textContent}`,[n,s]=[t,e].map(o=>o.replaceAll("&","&amp;").replaceAll('"',"&quot;").replaceAll("<","&lt;")),r=`<iframe src="${n}" title="${s}" loading="lazy" sandbox="allow-scripts allow-downloads" allow="clipboard-write" style="width:100%; height:${DA}px; border:0"></iframe>`;return this.copy(r,"The code is copied: paste it into the HTML of a page.")}copySpec(){let t=this.page.instrument.toml(this.page.motion.span);return t===null?this.say("No spec says this start. A gyrostat needs its rotor's moment, and a free rotor a principal axis; a disk must begin in steady rolling."):this.copy(t,"The spec is copied: paste it into a file, and run polhode report on it.")}savePicture(){let t=this.page.shot();if(Ng()){let e=Ln("saved");return e.src=t.toDataURL("image/png"),e.hidden=!1,this.say("A frame like this one may not save files: save the picture below by a right click, or by a long press.")}return t.toBlob(e=>this.save(e,"png"),"image/png"),this.say("The picture is saved.")}saveFilm(){if(!Ig())return this.say("This browser cannot record films: it has no MediaRecorder for canvases. Firefox and Chromium have.");let t=this.check();if(t===null)return;let{timebar:e}=this.page,n=e.playing,s=()=>this.say(`Recording: ${Math.min(this.film.passed,t).toFixed(1)} of ${$t(t,3)} s.`),r=setInterval(s,200);return this.film=new rh(this.page.shot(),t,(o,a)=>{clearInterval(r),this.film=null,Ln("film").textContent="Save film",n||e.pause(),o&&this.save(o,a),this.say(o?Ng()?"The film is recorded. If it was not saved, this frame may not save files: open the page on its own.":"The film is saved.":"The browser has recorded nothing.")}),Ln("film").textContent="Stop",n||e.toggle(),s()}frame(){this.film?.paint(t=>this.page.shot(t))}suggest(){if(this.given!==null)return;let{instrument:t,motion:e,timebar:n}=this.page,{period:s=null,nutationPeriod:r=null}=e?.solver??{},a=([s,r,t?.event??null].find(l=>l!==null&&Number.isFinite(l)&&l>0)??e?.span??0)/n.rate,c=a>0&&Number.isFinite(a)?Math.min(fd,Math.max(dd,a)):UA;Ln("film-length").value=String(Number(c.toFixed(1)))}check(){let t=Ln("film-length"),e=Number(t.value.trim().replace(",",".")),n=t.value.trim()!==""&&e>=dd&&e<=fd;return t.setAttribute("aria-invalid",String(!n)),this.say(n?"":`A film takes ${dd} to ${fd} s; got ${t.value.trim()||"nothing"}. Type a number between these.`),this.given=n?e:this.given,n?e:null}save(t,e){let n=document.createElement("a");n.href=URL.createObjectURL(t),n.download=`${Ln("name").textContent.replace(/[^\p{L}\p{N}]+/gu,"-").replace(/^-+|-+$/g,"")||"motion"}.${e}`,n.click(),setTimeout(()=>URL.revokeObjectURL(n.href),6e4)}};function Ng(){try{return window.self!==window.top&&!window.localStorage}catch{return!0}}var OA="#E69F00",Dg="#009E73",Ug="#D55E00",FA="#CC79A7",bs={light:{name:"light",ground:"#ffffff",text:"#222222",motion:"#0072B2",border:Ug,stable:Dg,family:"#8a8a8a",velocity:"#a8477c",rotor:Ug,momentum:"#222222",axes:["#0072B2","#c78500",Dg],sphere:"#eef1f4",body:"#b9c6d3",edge:"#5a6672",plane:"#dfe4e8",ring:"#b4bcc4",lamp:1},dark:{name:"dark",ground:"#14171b",text:"#e6e6e6",motion:"#56B4E9",border:"#f0803c",stable:"#1fbf92",family:"#7d848c",velocity:FA,rotor:"#f0803c",momentum:"#f2f2f2",axes:["#56B4E9",OA,"#1fbf92"],sphere:"#2a3038",body:"#66727f",edge:"#aab4be",plane:"#2a3038",ring:"#4c5660",lamp:1.1}};var aa=Math.SQRT2,[BA,zA]=[.5,8],kA=1.5,Og=[.5,1.6],GA=20,[Fg,VA]=[8,240],[HA,WA]=[1,3600],Bg=20,ah=class{constructor(t,{seek:e,beyond:n,told:s}){this.root=t,this.seek=e,this.beyond=n,this.told=s,this.position=0,this.playing=!1,this.looping=!1,this.goesOn=!1,this.slider=t.querySelector("#seek"),this.play=t.querySelector("#play"),this.loop=t.querySelector("#loop"),this.speed=t.querySelector("#speed"),this.shown=t.querySelector("#now");let r=(o,a)=>t.querySelector(o).addEventListener("click",a);r("#play",()=>this.toggle()),r("#back",()=>this.step(-1)),r("#forth",()=>this.step(1)),r("#loop",()=>this.repeat()),r("#slower",()=>this.scale(1/aa)),r("#faster",()=>this.scale(aa)),this.slider.addEventListener("input",()=>{this.pause(),this.go(Number(this.slider.value))}),document.addEventListener("keydown",o=>this.key(o))}take(t,e,n=null,s=null){this.motion=t,this.slider.max=String(t.count-1),this.single=t.count<2||!(t.span>0);for(let r of this.root.querySelectorAll("button, input"))r.disabled=this.single;this.loop.hidden=!!t.endless,e&&(this.rate=qA(t,s),this.pause()),n===null?this.go(0):this.goTo(n)}key(t){if(this.single||t.ctrlKey||t.metaKey||t.altKey||t.target!==this.slider&&t.target.closest?.("input, select, textarea"))return;let e=t.target===this.slider,n=t.target.closest?.("button, a, summary");if(t.target.closest?.("canvas")&&t.key.startsWith("Arrow"))return;let r={" ":()=>!n&&this.toggle(),k:()=>this.toggle(),l:()=>this.repeat(),ArrowLeft:()=>!e&&this.step(t.shiftKey?-Bg:-1),ArrowRight:()=>!e&&this.step(t.shiftKey?Bg:1),Home:()=>!e&&this.home(),End:()=>!e&&this.to(this.motion.count-1),"+":()=>this.scale(aa),"=":()=>this.scale(aa),"-":()=>this.scale(1/aa)}[t.key];r&&r()!==!1&&t.preventDefault()}toggle(){if(this.playing)return this.pause();this.position>=this.motion.count-1&&!this.motion.endless&&!this.goesOn&&this.go(0),this.playing=!0,this.begun=null,this.say(),requestAnimationFrame(t=>this.tick(t))}pause(){this.playing=!1,this.say()}repeat(){this.looping=!this.looping,this.say()}home(){if(!this.motion.endless)return this.to(0);this.pause(),this.beyond(this.motion.solver.epoch)}tick(t){if(!this.playing)return;let e=this.begun===null?0:Math.min((t-this.begun)/1e3,.25);this.begun=t,this.advance(this.time+e*this.rate),this.playing&&requestAnimationFrame(n=>this.tick(n))}advance(t){let e=this.motion.times[this.motion.count-1];if(t<=e)return this.goTo(t);if(this.motion.endless||this.goesOn&&!this.looping)return this.beyond(t);if(this.looping)return this.goTo(this.motion.times[0]+(t-e)%this.motion.span);this.goTo(e),this.pause()}step(t){this.to(Math.round(this.position)+t)}to(t){this.pause(),this.go(t)}go(t){this.position=Math.min(this.motion.count-1,Math.max(0,t)),this.time=this.motion.at(this.position).time,this.refresh()}goTo(t){this.time=t,this.position=this.motion.positionOf(t),this.refresh()}refresh(){this.slider.value=String(Math.round(this.position)),this.slider.style.setProperty("--part",`${100*this.position/Math.max(1,this.motion.count-1)}%`);let t=ii(this.time,Math.max(this.motion.span,Math.abs(this.time)));this.slider.setAttribute("aria-valuetext",t),this.shown.textContent=t,this.seek(this.position,this.time)}scale(t){let{span:e}=this.motion;this.rate=Math.min(e/HA,Math.max(e/WA,this.rate*t)),this.say()}say(){this.play.setAttribute("aria-label",this.playing?"Pause":"Play"),this.play.dataset.playing=String(this.playing),this.loop.setAttribute("aria-pressed",String(this.looping)),this.rate&&(this.speed.textContent=Math.abs(this.rate-1)<.05?"real time":`\xD7${$t(this.rate,2)}`),this.told()}};function qA(i,t){if(!(i.span>0))return 1;let e=i.hasUp?zA:BA,n=i.fastest?2*Math.PI*e/i.fastest:i.span/40,s=i.solver?.nutationPeriod,r=s&&Number.isFinite(s)?s/kA:1/0,o=Math.min(i.span/Fg,Math.max(i.span/VA,Math.min(n,r))),a=Math.min(i.span/Fg,(t??0)/GA);if(o>Og[0]&&o<Og[1]&&a<=1)return 1;if(a>o)return XA(a);let c=10**Math.floor(Math.log10(o));return([5,2,1].find(h=>h*c<=o*1.0001)??1)*c}function XA(i){let t=10**Math.floor(Math.log10(i));return[1,2,5,10].find(e=>e*t>=.9999*i)*t}var xd={};qi(xd,{BufferGeometry:()=>Ee,Color:()=>zt,ConeGeometry:()=>Qi,CylinderGeometry:()=>Kn,DataTexture:()=>Ii,Float32BufferAttribute:()=>re,Group:()=>ye,InstancedMesh:()=>fo,LinearFilter:()=>Oe,Matrix4:()=>te,Mesh:()=>ee,MeshBasicMaterial:()=>hn,MeshLambertMaterial:()=>Tn,PlaneGeometry:()=>Ls,Quaternion:()=>ae,SphereGeometry:()=>En,Vector3:()=>I,circle:()=>vi,dot:()=>Ms,drawUpTo:()=>Vi,endsLegend:()=>gd,floor:()=>Vr,globe:()=>Gr,line:()=>mn,mapGlobe:()=>kg,mappedGlobe:()=>md,newPanel:()=>In,pairThrough:()=>Yo,path:()=>Gi,pieces:()=>kr,polhodeThrough:()=>zs,specks:()=>ia,unpacked:()=>ue});var pd=[[33,102,172],[178,24,43]],zg=247,$A=6;function YA(){let i=new Uint8Array(1024);for(let t=0;t<256;t++){let e=t<127.5?0:1,n=Math.abs(t-127.5)/127.5;for(let s=0;s<3;s++)i[4*t+s]=Math.round(zg+(pd[e][s]-zg)*n**.8);i[4*t+3]=255}return i}function ZA(i,t,e){let n=t*e,s=(a,c,l)=>Array.from({length:a},(h,u)=>{let d=(u+.5)/e-.5,f=Math.floor(d),p=x=>l?(x+c)%c:Math.min(Math.max(x,0),c-1);return[p(f),p(f+1),d-f]}),r=s(n,t,!0),o=s(i*e,i,!1);return(a,c,l)=>{o.forEach(([h,u,d],f)=>{let p=c+h*t,x=c+u*t;for(let m=0;m<n;m++){let[g,y,S]=r[m],v=a[p+g]+S*(a[p+y]-a[p+g]),A=a[x+g]+S*(a[x+y]-a[x+g]);l[f*n+m]=v+d*(A-v)}})}}function md(i,t){let e=i*t,n=YA(),s=new Uint8Array(4*e),r=new Ii(s,t,i);r.magFilter=r.minFilter=Oe,r.colorSpace="srgb";let o=new En(1,96,64);return o.rotateX(Math.PI/2),o.rotateZ(Math.PI),{mesh:new ee(o,new hn({map:r})),paint:(l,h=null)=>{for(let u=0;u<e;u++){let d=Math.round(l[u]);if(s.set(n.subarray(4*d,4*d+4),4*u),h?.(u))for(let f=0;f<3;f++)s[4*u+f]*=.35}r.needsUpdate=!0},pixels:s}}var gd=i=>[{color:`rgb(${pd[1].join(", ")})`,text:i[1]},{color:`rgb(${pd[0].join(", ")})`,text:i[0]}];function kg(i,t,{title:e,words:n,legend:s}){let r=i.lines?$A:1,[o,a]=[i.rows*r,i.columns*r],c=ue(i.levels),l=i.lines?ue(i.lines):null,h=ue(i.frames),[u,d]=[i.rows*i.columns,o*a],f=ZA(i.rows,i.columns,r),{mesh:p,paint:x,pixels:m}=md(o,a),[g,y,S]=[new Float32Array(d),new Float32Array(d),new Uint8Array(d)],v=In(t,{title:e,words:n,radius:1.3});v.scene.add(p);for(let M of[-.5,0,.5])v.scene.add(vi(1.002*Math.sqrt(1-M*M),1.002*M,t.family));v.legend=gd(s);let A=(M,C,T,L)=>{if(f(M,u*C,g),L!==0){f(M,u*T,y);for(let N=0;N<d;N++)g[N]+=L*(y[N]-g[N])}},w=M=>{let C=M%a===a-1?M+1-a:M+1,T=M+a<d?M+a:M;return S[M]!==S[C]||S[M]!==S[T]},_=-1;return v.update=M=>{if(M.position===_)return;_=M.position;let C=0;for(;C<h.length-2&&h[C+1]<=M.position;)C++;let T=Math.min(C+1,h.length-1),L=T>C?Math.min(1,(M.position-h[C])/(h[T]-h[C])):0;if(l){A(l,C,T,L);for(let N=0;N<d;N++)S[N]=Math.floor(g[N]/256*i.bands)}A(c,C,T,L),x(g,l&&w)},v.probe=()=>({shown:_,pixels:[...m.subarray(0,16)]}),v}var JA={axis:xg,body:Sg,poinsot:bg,sphere:Tg,...globalThis.polhodePanels},Nn=i=>document.getElementById(i),_d=class{constructor(t){this.view=new xl(()=>this.draw()),this.stage=new th(this.view),this.panels=[],this.canvases=[],this.waiting=null;let e=window.matchMedia("(prefers-color-scheme: dark)");this.theme=e.matches?bs.dark:bs.light,e.addEventListener("change",s=>this.dress(s.matches?bs.dark:bs.light)),Nn("theme").addEventListener("click",()=>this.dress(this.theme===bs.dark?bs.light:bs.dark)),Nn("reset").addEventListener("click",()=>this.instrument?.reset());for(let s of document.querySelectorAll("button"))s.addEventListener("pointerup",()=>s.blur());new ResizeObserver(()=>this.sizes()!==this.shapes&&this.draw()).observe(Nn("panels")),this.room=new Yl(["summary","refused","facts","notes","readouts","plots"].map(Nn)),this.plots=new eh(Nn("plots"),s=>{this.timebar.pause(),this.goTo(s)}),this.timebar=new ah(Nn("timebar"),{seek:(s,r)=>this.show(s,r),beyond:s=>this.goTo(s),told:()=>this.told()}),this.address=new ha(()=>this.seen,s=>this.open(this.playground?.find(s.preset)??t,s)),this.views=new $l(Nn("panels"),()=>this.looked()),this.sharing=new oh(this),this.playground=t.presets?new ih(t.presets,s=>this.open(s),s=>this.tell(s)):null;let{tables:n}=this.address;this.open(this.playground?.find(n.preset)??t,n)}open(t,e=null){let n=this.timebar.playing;this.data=t,Iu(t),this.room.release(),this.view.letGo(),this.view.elevation=t.panels[0].elevation??this.view.elevation,this.view.azimuth=t.panels[0].azimuth??this.view.azimuth,this.instrument=null,this.shaped=!1,Nn("instrument").hidden=!t.model,t.model&&(this.instrument=new Xl(t.model,s=>this.reset(s)),this.epoch=this.instrument.setting.epoch),this.motion=t.model&&!t.attitude?this.instrument.motion(KA(t),t.space):new kl(t),Nn("panels").replaceChildren(),this.canvases=t.panels.map(s=>Lp(s,this.view)),this.canvases.forEach((s,r)=>this.listen(s,r)),this.views.take(t.panels.map(({type:s})=>s)),this.readouts=new sh(Nn("readouts"),this.motion,t),this.now=this.motion.at(0),this.build(),this.timebar.goesOn=!!this.instrument,this.timebar.take(this.motion,!0,null,this.instrument?.event),this.sharing.take(),e&&this.restore(e),n&&this.timebar.toggle(),this.address.write()}restore({t=null,preset:e,view:n=null,...s}){Object.keys(s).length&&this.instrument?.set(s),n!==null&&this.views.enlarge(String(n)),typeof t=="number"&&this.goTo(t)}get seen(){let{key:t}=this.data,{named:e}=this.views,n=!this.timebar.playing&&this.now.time!==this.begins;return{...t?{preset:t}:{},...this.instrument?.tables,...e?{view:e}:{},...n?{t:this.now.time}:{}}}get begins(){return this.instrument?.setting.epoch??this.motion.times[0]}tell({set:t,view:e}){return e?this.views.enlarge(e):(t?this.instrument?.set(t):this.instrument?.reset(),this.goTo(this.begins),!Gg()&&!this.timebar.playing&&this.timebar.toggle(),this.address.write())}looked(){this.view.letGo(),this.draw(),this.address.write()}told(){this.sharing&&this.motion&&this.sharing.suggest(),this.instrument!==void 0&&this.address.changed()}reset(t){this.room.keep();let{epoch:e}=this.instrument.setting,n=e===this.epoch?this.now.time:e;this.epoch=e,this.shaped=t,Nn("summary").textContent=this.instrument.isAsGiven?this.data.summary:"Set on this page.";let s=this.instrument.motion();this.motion=s.around(n),this.readouts.take(this.motion,this.data,!0),this.build(),this.timebar.take(this.motion,!1,n),this.sharing.suggest(),this.room.keep(),this.address.changed()}build(){for(let e of this.panels)mg(e.scene);document.documentElement.dataset.theme=this.theme.name,this.panels=this.data.panels.map(e=>{let n=this.changedPanel(e);return Object.assign(JA[e.type](this.motion,n,this.theme,xd),{type:e.type})}),this.panels.forEach((e,n)=>Np(this.canvases[n],e,this.data));let t=this.instrument&&!this.instrument.isAsGiven;this.plots.take(this.motion,t?{...this.data,scatters:[],plots:[]}:this.data,this.theme),this.draw()}changedPanel(t){return this.shaped&&t.type==="body"?{...t,surface:null,ellipsoid:null,changed:!0}:this.instrument&&!this.instrument.isAsGiven&&t.type==="sphere"?{...t,changed:!0,equilibria:null}:t}dress(t){this.theme=t,this.build()}show(t,e){this.now=this.motion.endless?{position:t,...this.motion.solvedAt(e)}:this.motion.at(t),this.timebar.playing||this.address.changed(),this.draw()}goTo(t){if(!Number.isFinite(t))return;let{times:e,count:n}=this.motion,s=t<e[0]||t>e[n-1],r=this.motion.endless?this.motion.around(t):s&&this.instrument?this.instrument.motion().around(t):this.motion;r!==this.motion?(this.motion=r,this.build(),this.timebar.take(r,!1,t)):this.timebar.goTo(t)}draw(){this.waiting??=requestAnimationFrame(()=>this.drawNow())}drawNow(){cancelAnimationFrame(this.waiting),this.waiting=null,this.shapes=this.sizes();for(let t of this.panels)t.update(this.now);this.stage.draw(this.panels,this.canvases,this.theme),this.plots.draw(this.now),this.readouts.show(this.now),this.sharing.frame(),window.polhode.drawn+=1,window.polhode.firstPicture??=performance.now()}drawn(){return this.waiting&&this.drawNow(),this}sizes(){return this.canvases.map(t=>`${t.clientWidth} ${t.clientHeight}`).join()}listen(t,e){let n=s=>{let r=t.getBoundingClientRect();return[(s.clientX-r.left)/r.width*2-1,1-(s.clientY-r.top)/r.height*2]};t.addEventListener("pointerdown",s=>{let r=this.panels[e];if(s.button!==0||!r.grasp||!this.instrument?.kind.dragged||!r.grasp(n(s),t.clientWidth))return;s.stopImmediatePropagation(),this.timebar.pause(),t.setPointerCapture(s.pointerId);let o=c=>{let l=this.panels[e].under(n(c));l&&(this.now={...this.now,time:this.instrument.setting.epoch},this.instrument.point(l))},a=()=>{t.removeEventListener("pointermove",o);for(let c of["pointerup","pointercancel"])t.removeEventListener(c,a)};t.addEventListener("pointermove",o);for(let c of["pointerup","pointercancel"])t.addEventListener(c,a)},{capture:!0})}shot(t=null){t||this.drawn();let e=this.canvases[this.views.large],n=t??document.createElement("canvas");t||([n.width,n.height]=[e.width,e.height].map(c=>c-c%2));let s=n.getContext("2d");s.fillStyle=this.theme.ground,s.fillRect(0,0,n.width,n.height);let r=Math.min(n.width/e.width,n.height/e.height),[o,a]=[e.width*r,e.height*r];return s.drawImage(e,.5*(n.width-o),.5*(n.height-a),o,a),n}},Gg=()=>window.matchMedia("(prefers-reduced-motion: reduce)").matches,KA=i=>ue(i.times);function jA(i){return{drawn:0,firstPicture:null,get count(){return i.motion.count},get times(){return i.motion.times},view:i.view,enlarge:t=>i.views.enlarge(t),shown:()=>({theme:i.theme.name,position:i.now.position,time:i.now.time}),seek(t){i.timebar.to(t),i.drawNow()},goTo(t){i.goTo(t),i.drawn()},get playing(){return i.timebar.playing},set:t=>i.instrument?.set(t)??!1,settings:()=>i.instrument?.kind.asSpec(i.instrument.setting)??null,state(t){let e=i.motion.endless?i.motion:i.instrument?.motion([t]),n=e?e.solvedAt(t):i.motion.at(i.motion.positionOf(t)),{w:s,x:r,y:o,z:a}=n.attitude??{};return{attitude:n.attitude?[s,r,o,a]:null,momentum:n.momentum?.toArray()??null}},spec:()=>i.instrument?.toml(i.motion.span)??null,plots:()=>i.drawn().plots.probe(),names:()=>i.drawn().panels.map(t=>t.boxes??[]),measure(t,...e){i.drawn();let n=i.panels.find(s=>s.type===t)?.probe();return n&&e.length?Object.fromEntries(e.map(s=>[s,n[s]])):n}}}try{let i=JSON.parse(Nn("motion").textContent);window.polhode={drawn:0,firstPicture:null},Iu(i.presets?i.presets[0]:i);let t=new _d(i);window.polhode=jA(t),window.seek=e=>window.polhode.seek(e),t.draw(),!Gg()&&t.motion.count>1&&t.motion.span>0&&requestAnimationFrame(()=>t.timebar.toggle())}catch(i){let t=Nn("failure");throw t.hidden=!1,t.textContent=`The pictures cannot be drawn (${i.message}). They need a browser with WebGL 2.`,i}})();
